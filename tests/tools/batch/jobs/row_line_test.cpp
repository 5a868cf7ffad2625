#include "tools/batch/jobs/row_line.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

TEST(RowLine, KeepsTheResultOfAJob) {
  const std::string line = done_row_line(4, R"(["a", 0.1, "two
lines"])");
  EXPECT_EQ(line.find('\n'), std::string::npos);
  EXPECT_EQ(head_of(line).job, 4);
  EXPECT_FALSE(head_of(line).failed);
  EXPECT_EQ(result_of_row(line), "[\"a\", 0.1, \"two\nlines\"]");
}

TEST(RowLine, KeepsWhyAJobFailed) {
  const std::string line = failed_row_line(7, "broke\nin two");
  EXPECT_EQ(head_of(line).job, 7);
  EXPECT_TRUE(head_of(line).failed);
  EXPECT_TRUE(contains(error_of([&] { result_of_row(line); }), "is no row"));
}

TEST(RowLine, NoticesEveryChangedCharacter) {
  const std::string line = done_row_line(4, "12");
  for (std::size_t i = 0; i < line.size(); ++i) {
    std::string changed = line;
    changed[i] = changed[i] == '1' ? '2' : '1';
    if (changed == line) continue;
    EXPECT_FALSE(error_of([&] { head_of(changed); }).empty()) << i;
  }
}

}  // namespace
}  // namespace castaway::testbed
