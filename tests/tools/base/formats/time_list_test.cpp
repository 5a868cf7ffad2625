#include "tools/base/formats/time_list.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

using Times = std::vector<std::chrono::nanoseconds>;
using std::chrono::nanoseconds;

Times times_in(const std::string& text) {
  const TemporaryFolder folder;
  return read_times(folder.put("times.txt", text));
}

std::string times_error(const std::string& text) {
  return error_of([&] { times_in(text); });
}

TEST(TimeList, IsReadBackToTheNanosecond) {
  const Times times{nanoseconds(0),
                    nanoseconds(1),
                    nanoseconds(999'999'999),
                    nanoseconds(1'000'000'000),
                    nanoseconds(1'234'567'891),
                    nanoseconds(86'400'123'456'789)};
  EXPECT_EQ(times_in(times_text(times)), times);
}

TEST(TimeList, IsWrittenWithNineDecimals) {
  EXPECT_EQ(times_text({nanoseconds(5), nanoseconds(12'030'000'000)}),
            "0.000000005\n12.030000000\n");
  EXPECT_EQ(times_text({}), "");
}

TEST(TimeList, SkipsEmptyLinesCommentsAndBlanks) {
  EXPECT_EQ(
      times_in("# times\n\n  0.5\t\r\n   \n1e1\n 10 \n  # the end"),
      (Times{nanoseconds(500'000'000), nanoseconds(10'000'000'000), nanoseconds(10'000'000'000)}));
}

TEST(TimeList, NamesTheLineThatIsNoTime) {
  for (const std::string line : {"soon", "1 2", "1,5", "-0.1", "nan", "inf", "1e10", "0.5s"}) {
    const std::string error = times_error("0\n\n" + line + "\n9\n");
    EXPECT_TRUE(contains(error, "times.txt:3: no time; write seconds")) << line;
  }
}

TEST(TimeList, NamesTheLineThatGoesBack) {
  EXPECT_TRUE(contains(times_error("1\n2\n# back\n1.999999999\n"),
                       "times.txt:4: goes back in time; sort the lines"));
}

TEST(TimeList, RefusesAFileWithoutTimes) {
  EXPECT_TRUE(contains(times_error("# none\n"), "times.txt: holds no times"));
  EXPECT_TRUE(contains(error_of([] { read_times("/nowhere/times.txt"); }), "/nowhere/times.txt"));
}

}  // namespace
}  // namespace castaway::testbed
