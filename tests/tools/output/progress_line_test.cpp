#include "tools/output/progress_line.hpp"

#include <pty.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

TEST(ProgressLine, IsCutByCharacters) {
  EXPECT_EQ(cut_to("12 / 30 cells", 20), "12 / 30 cells");
  EXPECT_EQ(cut_to("12 / 30 cells", 7), "12 / 30");
  EXPECT_EQ(cut_to("Räume", 2), "Rä");
  EXPECT_EQ(cut_to("", 0), "");
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
