#include "tools/metrics/statistics/wrong_time.hpp"

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

TEST(WrongTime, IsTheLongestOfThoseWithoutABreak) {
  WrongTime time;
  EXPECT_EQ(time.longest_s(), 0.0);
  const bool wrong[] = {true, false, true, true, true, false, true, true, false};
  for (int i = 0; i < 9; ++i) time.take(std::chrono::seconds(i), wrong[i]);
  EXPECT_EQ(time.longest_s(), 2.0);  // From 2 s to 4 s.
}

TEST(WrongTime, OfASingleScanIsNone) {
  WrongTime time;
  time.take(std::chrono::seconds(1), true);
  time.take(std::chrono::seconds(9), false);
  EXPECT_EQ(time.longest_s(), 0.0);
}

}  // namespace
}  // namespace castaway::testbed
