#include "tools/base/process/progress_text.hpp"

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

TEST(ProgressText, TellsRateAndTimeLeft) {
  EXPECT_EQ(progress_text(12, 300, "runs", 3.0), "12 / 300 runs, 4 a second, 1 min 12 s left");
  EXPECT_EQ(progress_text(1, 3, "runs", 10.0), "1 / 3 runs, 0.1 a second, 20 s left");
  EXPECT_EQ(progress_text(3, 3, "runs", 10.0), "3 / 3 runs, 0.3 a second, 0 s left");
}

TEST(ProgressText, KnowsNoRateBeforeTheFirstIsDone) {
  EXPECT_EQ(progress_text(0, 3, "runs", 10.0), "0 / 3 runs");
}

TEST(MinutesAndSeconds, AreRoundedDown) {
  EXPECT_EQ(minutes_and_seconds(59.9), "59 s");
  EXPECT_EQ(minutes_and_seconds(725.0), "12 min 05 s");
}

}  // namespace
}  // namespace castaway::testbed
