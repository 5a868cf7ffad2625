#include "tools/run/metrics/statistics/wrong_time.hpp"

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

TEST(WrongTime, IsTheLongestOfThoseWithoutABreak) {
  WrongTime time;
  EXPECT_EQ(time.longest_s(), 0.0);
  const bool wrong[] = {true, false, true, true, true, false, true, true, false};
  for (int i = 0; i < 9; ++i) time.take(std::chrono::seconds(i), wrong[i]);
  EXPECT_EQ(time.longest_s(), 3.0);  // From 2 s to 5 s.
  EXPECT_EQ(time.total_s(), 1.0 + 3.0 + 2.0);
}

TEST(WrongTime, OfASingleScanLastsUntilTheNextOne) {
  WrongTime time;
  time.take(std::chrono::seconds(1), true);
  EXPECT_EQ(time.longest_s(), 0.0);
  time.take(std::chrono::seconds(9), false);
  EXPECT_EQ(time.longest_s(), 8.0);
}

TEST(WrongTime, OfTheLastScanLastsUntilTheEnd) {
  WrongTime time;
  time.take(std::chrono::seconds(1), true);
  time.take(std::chrono::seconds(2), true);
  EXPECT_EQ(time.total_s(), 1.0);
  time.finish(std::chrono::seconds(5));
  EXPECT_EQ(time.total_s(), 4.0);
  EXPECT_EQ(time.longest_s(), 4.0);
}

TEST(WrongTime, DoesNotRunBackwards) {
  WrongTime time;
  time.take(std::chrono::seconds(3), true);
  time.finish(std::chrono::seconds(1));
  EXPECT_EQ(time.total_s(), 0.0);
}

}  // namespace
}  // namespace castaway::testbed
