#include "tools/base/output/progress_line.hpp"

#include <pty.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

TEST(ProgressLine, IsCutByCharacters) {
  EXPECT_EQ(progress_text("12 / 30 cells", 14), "12 / 30 cells");
  EXPECT_EQ(progress_text("12 / 30 cells", 13), "12 / 30 cell");
  EXPECT_EQ(progress_text("Räume", 3), "Rä");
  EXPECT_EQ(progress_text("", 10), "");
}

TEST(ProgressLine, IsWholeWhereTheWidthIsNotKnown) {
  EXPECT_EQ(progress_text("12 / 30 cells", std::string::npos), "12 / 30 cells");
  EXPECT_EQ(progress_text("12 / 30 cells", 1), "12 / 30 cells");
}

TEST(ProgressLine, KnowsTheTerminalsWidth) {
  int first = -1;
  int second = -1;
  winsize size{};
  size.ws_row = 24;
  size.ws_col = 57;
  ASSERT_EQ(openpty(&first, &second, nullptr, nullptr, &size), 0);
  std::FILE* terminal = fdopen(second, "w");
  EXPECT_EQ(columns_of(terminal), 57U);
  std::fclose(terminal);
  close(first);
  std::FILE* file = std::tmpfile();
  EXPECT_EQ(columns_of(file), std::string::npos);
  std::fclose(file);
}

}  // namespace
}  // namespace castaway::testbed
