#include "localization/sensor/scan_continuity.hpp"

#include <gtest/gtest.h>

#include "tests/support/grid_world.hpp"
#include "tests/support/scan_points.hpp"

namespace castaway::localization {
namespace {

class ScanContinuityTest : public testing::Test {
 protected:
  ScanPoints scan_from(const SE2& pose) const { return test::points_from(grid_, pose); }
  /// Lets it learn from a robot at rest.
  void rest(int scans) {
    for (int k = 0; k < scans; ++k) EXPECT_EQ(continuity_.take(here_, here_, {}), 0.0);
  }

  OccupancyGrid grid_ = test::office();
  SE2 pose_{3.0, 3.0, 0.4};
  ScanPoints here_ = scan_from(pose_);
  ScanContinuityConfig config_;
  ScanContinuity continuity_{config_};
};

TEST_F(ScanContinuityTest, LearnsHowWellTheScansOfOnePlaceAgree) {
  rest(1);
  EXPECT_EQ(continuity_.usual(), 1.0);
  rest(200);
  EXPECT_EQ(continuity_.usual(), 1.0);
  EXPECT_EQ(continuity_.spread(), config_.least_spread);
  continuity_.start();
  EXPECT_EQ(continuity_.spread(), config_.spread_start);
}

TEST_F(ScanContinuityTest, NoticesAStepThatOdometryDidNotSee) {
  rest(30);
  const double cue = continuity_.take(here_, scan_from(pose_ * SE2{0.2, 0.0, 0.0}), {});
  EXPECT_GT(cue, 3.0);
  EXPECT_LE(cue, config_.most);
}

TEST_F(ScanContinuityTest, IsOneNatForEachSpreadBeyondTheFreeOnes) {
  rest(200);
  const ScanPoints beside = scan_from(pose_ * SE2{0.1, 0.0, 0.0});
  const double share = *scan_agreement(config_.agreement, here_, beside, {});
  const double expected = (1.0 - share) / config_.least_spread - config_.free;
  ASSERT_GT(expected, 0.0);
  EXPECT_NEAR(continuity_.take(here_, beside, {}), std::min(expected, config_.most), 1e-9);
}

TEST_F(ScanContinuityTest, FollowsAStepOfOdometry) {
  rest(30);
  for (const SE2& u : {SE2{0.3, 0.0, 0.1}, SE2{2.0, 0.3, 0.4}}) {
    EXPECT_EQ(continuity_.take(here_, scan_from(pose_ * u), u), 0.0);
  }
}

TEST_F(ScanContinuityTest, NoticesAJumpInALongStep) {
  const SE2 u{1.0, 0.0, 0.2};
  SE2 pose = pose_;
  for (int k = 0; k < 3; ++k, pose = pose * u) {
    EXPECT_EQ(continuity_.take(scan_from(pose), scan_from(pose * u), u), 0.0);
  }
  const ScanPoints elsewhere = scan_from(pose * u * SE2{0.0, 0.0, 3.1});
  EXPECT_GT(continuity_.take(scan_from(pose), elsewhere, u), 3.0);
}

TEST_F(ScanContinuityTest, SaysNothingOfScansFarApart) {
  rest(30);
  const ScanPoints elsewhere = scan_from({8.0, 6.5, 2.0});
  EXPECT_EQ(continuity_.take(here_, elsewhere, {2.6, 0.0, 0.0}), 0.0);
  EXPECT_EQ(continuity_.take(here_, elsewhere, {0.0, 0.0, 1.25}), 0.0);
  EXPECT_EQ(continuity_.take(here_, {}, {}), 0.0);
}

}  // namespace
}  // namespace castaway::localization
