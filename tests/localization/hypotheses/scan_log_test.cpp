#include "localization/hypotheses/scan_log.hpp"

#include <optional>

#include <gtest/gtest.h>

#include "tests/support/grid_world.hpp"
#include "tests/support/scan_points.hpp"

namespace castaway::localization {
namespace {

TEST(Independence, GrowsWithTheWayFromALeastValueToOne) {
  const ScanComparisonConfig config;
  EXPECT_DOUBLE_EQ(independence(config, 0.0, 0.0), 0.15);
  EXPECT_DOUBLE_EQ(independence(config, 0.6, 0.0), 0.5);
  EXPECT_DOUBLE_EQ(independence(config, 0.6, 0.18), 0.8);
  EXPECT_DOUBLE_EQ(independence(config, 2.0, 0.0), 1.0);
}

TEST(KidnapCue, SpeaksAgainstAKidnapWhereScansAgreeAndForOneWhereTheyDoNot) {
  EXPECT_DOUBLE_EQ(kidnap_cue({}, std::nullopt, 1.0), 0.0);
  EXPECT_NEAR(kidnap_cue({}, 0.95, 1.0), -9.0, 1e-12);
  EXPECT_DOUBLE_EQ(kidnap_cue({}, 0.65, 1.0), 0.0);
  EXPECT_DOUBLE_EQ(kidnap_cue({}, 0.5, 1.0), 0.0);
  EXPECT_NEAR(kidnap_cue({}, 0.25, 1.0), 2.0, 1e-12);
}

TEST(KidnapCue, ExpectsMoreAgreementOfARobotAtRest) {
  const ScanComparisonConfig config;
  const double rest = config.least_independence;
  EXPECT_NEAR(kidnap_cue(config, 0.95, rest), -3.0, 1e-12);
  EXPECT_DOUBLE_EQ(kidnap_cue(config, 0.85, rest), 0.0);
  EXPECT_NEAR(kidnap_cue(config, 0.95, 0.5 * (0.5 + rest)), -6.0, 1e-12);
  EXPECT_NEAR(kidnap_cue(config, 0.25, rest), 2.0, 1e-12);
}

class ScanLogTest : public testing::Test {
 protected:
  const ScanMemory& add(const ScanPoints& points, const SE2& T_odom_base, double listed = 0.0,
                        double null = 0.0) {
    return log_.add({.points = points,
                     .T_odom_base = T_odom_base,
                     .listed_before = listed,
                     .null_before = null});
  }

  ScanPoints here_ = test::points_from(test::office(), {3.0, 3.0, 0.4});
  ScanPoints elsewhere_ = test::points_from(test::office(), {8.0, 6.5, 2.0});
  ScanLog log_{{{}, {}, {}, 3}};
};

TEST_F(ScanLogTest, KeepsTheLastScansAsTheyCame) {
  EXPECT_FALSE(log_.T_odom_base());
  for (int k = 0; k < 5; ++k) add(here_, {0.1 * k, 0.0, 0.0}, -1.0 * k, -2.0 * k);
  ASSERT_EQ(log_.scans().size(), 3U);
  EXPECT_EQ(log_.scans().front().T_odom_base.x, 0.2);
  EXPECT_EQ(log_.scans().front().listed_before, -2.0);
  EXPECT_EQ(log_.scans().front().null_before, -4.0);
  EXPECT_EQ(log_.T_odom_base()->x, 0.4);
  log_.forget_motion();
  EXPECT_FALSE(log_.T_odom_base());
}

TEST_F(ScanLogTest, SaysHowMuchOfAScanIsNew) {
  EXPECT_EQ(add(here_, {}).independence, 1.0);
  EXPECT_EQ(add(here_, {}).independence, 0.15);
  EXPECT_NEAR(add(here_, {0.6, 0.0, 0.0}).independence, 0.5, 1e-12);
  EXPECT_NEAR(add(here_, {0.6, 0.0, -0.3}).independence, 0.5, 1e-12);
}

TEST_F(ScanLogTest, LetsTheCueOfAKidnapFadeByANatPerNewScan) {
  EXPECT_EQ(add(here_, {}).kidnap_cue, 0.0);
  const double cue = add(elsewhere_, {}).kidnap_cue;  // kidnapped
  ASSERT_GT(cue, 0.5);
  EXPECT_EQ(log_.recent_cue(), cue);
  ASSERT_LT(add(elsewhere_, {}).kidnap_cue, 0.0);
  EXPECT_NEAR(log_.recent_cue(), cue - 0.15, 1e-12);
  log_.start();
  EXPECT_EQ(log_.recent_cue(), 0.0);
  EXPECT_TRUE(log_.scans().empty());
}

TEST_F(ScanLogTest, NoticesAJumpThatTheTolerantComparisonMisses) {
  const ScanPoints beside = test::points_from(test::office(), SE2{3.15, 3.0, 0.45});
  add(here_, {});
  for (int k = 0; k < 20; ++k) {
    const ScanMemory& scan = add(here_, {});
    EXPECT_EQ(scan.arrival_cue, scan.kidnap_cue);
  }
  const ScanMemory& jump = add(beside, {});
  EXPECT_LE(jump.kidnap_cue, 0.0);
  EXPECT_GT(jump.arrival_cue, 3.0);
  EXPECT_EQ(log_.recent_cue(), jump.arrival_cue);
}

TEST_F(ScanLogTest, ComparesScansThroughTheStepOfOdometry) {
  const SE2 u{0.3, 0.1, 0.2};
  const ScanPoints moved = test::points_from(test::office(), SE2{3.0, 3.0, 0.4} * u);
  add(here_, {5.0, 1.0, 0.7});
  EXPECT_LT(add(moved, SE2{5.0, 1.0, 0.7} * u).kidnap_cue, -3.0);
}

}  // namespace
}  // namespace castaway::localization
