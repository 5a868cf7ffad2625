#include "tools/base/output/clock_file.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"
#include "tools/pages/html/html_page.hpp"

namespace castaway::testbed {
namespace {

TEST(ClockFile, IsOneOfThreeNamesAtTheTop) {
  for (const char* name : {"report.html", "timing.csv", "timing.json"}) {
    EXPECT_TRUE(holds_clock_readings(name));
    EXPECT_FALSE(holds_clock_readings(std::string("seed-1/") + name));
  }
  EXPECT_FALSE(holds_clock_readings("summary.json"));
}

TEST(ClockFile, IsKnownByItsBeginning) {
  const TemporaryFolder folder;
  EXPECT_TRUE(is_clock_file(folder.put("report.html", html_page({.title = "x", .body = "b"}))));
  EXPECT_TRUE(is_clock_file(folder.put("timing.csv", "stamp_s,localizer,stage,cpu_ms\n")));
  EXPECT_TRUE(is_clock_file(folder.put("timing.json", "{\n  \"wall_s\": 1.0\n}\n")));
  EXPECT_TRUE(is_clock_file(folder.put("timing.json", "{\n  \"figures\": {}\n}\n")));
  EXPECT_FALSE(is_clock_file(folder.put("timing.txt", "stamp_s,localizer,stage,cpu_ms\n")));
  for (const char* name : {"report.html", "timing.csv", "timing.json"}) {
    EXPECT_FALSE(is_clock_file(folder.put(name, "<title>my thesis</title>")));
    EXPECT_FALSE(is_clock_file(folder.put(name, "")));
  }
}

}  // namespace
}  // namespace castaway::testbed
