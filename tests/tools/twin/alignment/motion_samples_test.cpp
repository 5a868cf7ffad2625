#include "tools/twin/alignment/motion_samples.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

using std::chrono::milliseconds;

constexpr double kLegTrack = 0.4;

void expect_pose(const SE2& pose, const SE2& expected, double tolerance = 1e-12) {
  EXPECT_NEAR(pose.x, expected.x, tolerance);
  EXPECT_NEAR(pose.y, expected.y, tolerance);
  EXPECT_NEAR(localization::wrap_angle(pose.yaw - expected.yaw), 0.0, tolerance);
}

/// A log with scans at these times [ms] and poses, without beams.
AlignedLog log_of(const std::vector<std::pair<int, SE2>>& scans) {
  AlignedLog log;
  for (const auto& [ms, T_map_base] : scans) {
    AlignedScan aligned;
    aligned.scan.stamp = milliseconds(ms);
    aligned.T_map_base = T_map_base;
    log.scans.push_back(aligned);
  }
  return log;
}

TEST(Legs, HaveOdometrysStepsAndTheMapsMotion) {
  AlignedLog log = log_of({{100, {1.0, 2.0, 0.5 * std::numbers::pi}}, {350, {1.0, 2.5, 1.8}}});
  const SE2 T_odom_start{-3.0, 4.0, 1.0};
  log.T_odom_base.add(milliseconds(100), T_odom_start);
  log.T_odom_base.add(milliseconds(350), T_odom_start * SE2{0.6, 0.0, 0.0});
  const std::vector<Leg> legs = take_legs(log, kLegTrack);
  ASSERT_EQ(legs.size(), 1U);
  EXPECT_FALSE(legs[0].breaks);
  ASSERT_EQ(legs[0].steps.size(), 3U);  // of at most 0.1 s
  for (const OdometryStep& step : legs[0].steps) {
    EXPECT_NEAR(step.along, 0.2, 1e-8);
    EXPECT_NEAR(step.across, 0.0, 1e-9);
    EXPECT_NEAR(step.turn, 0.0, 1e-9);
    EXPECT_NEAR(step.way, 0.2, 1e-8);
  }
  EXPECT_NEAR(legs[0].way, 0.6, 1e-9);
  expect_pose(legs[0].T_start_end, {0.5, 0.0, 1.8 - 0.5 * std::numbers::pi});
}

TEST(Legs, OfAStandingRobotHaveNoTravel) {
  AlignedLog log = log_of({{0, {}}, {200, {}}, {400, {}}});
  log.T_odom_base.add(milliseconds(0), {1.0, 2.0, 3.0});
  log.T_odom_base.add(milliseconds(400), {1.0, 2.0, 3.0});
  const std::vector<Leg> legs = take_legs(log, kLegTrack);
  ASSERT_EQ(legs.size(), 2U);
  for (const Leg& leg : legs) {
    EXPECT_NEAR(leg.way, 0.0, 1e-12);
    expect_pose(correct_motion(leg.steps, {0.1, 0.1, 0.1}), {});
    EXPECT_FALSE(leg.breaks);
  }
}

TEST(Legs, BreakWhereTheRobotWasMovedOrOdometryIsMissing) {
  AlignedLog log = log_of({{0, {}}, {100, {}}, {200, {}}, {300, {}}, {2000, {}}});
  log.scans[2].breaks = true;
  log.T_odom_base.add(milliseconds(50), {});
  log.T_odom_base.add(milliseconds(300), {0.1, 0.0, 0.0});
  const std::vector<Leg> legs = take_legs(log, kLegTrack);
  ASSERT_EQ(legs.size(), 4U);
  EXPECT_TRUE(legs[0].breaks);  // begins before odometry
  EXPECT_TRUE(legs[1].breaks);  // to the scan after the move
  EXPECT_FALSE(legs[2].breaks);
  EXPECT_TRUE(legs[3].breaks);  // ends after odometry
  EXPECT_TRUE(take_legs(log_of({{0, {}}}), kLegTrack).empty());
  EXPECT_TRUE(take_legs(log_of({}), kLegTrack).empty());
}

TEST(Legs, WithoutErrorsReproduceOdometry) {
  AlignedLog log = log_of({{0, {}}, {230, {}}, {510, {}}, {990, {}}});
  for (int ms = 0; ms <= 1000; ms += 10) {
    const double t = 0.001 * ms;
    log.T_odom_base.add(milliseconds(ms), {std::sin(2.0 * t), t * t, 6.0 * std::cos(3.0 * t)});
  }
  const std::vector<Leg> legs = take_legs(log, kLegTrack);
  ASSERT_EQ(legs.size(), 3U);
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const SE2 T_odom_start = *log.T_odom_base.at(log.scans[i].scan.stamp);
    const SE2 T_odom_end = *log.T_odom_base.at(log.scans[i + 1].scan.stamp);
    expect_pose(correct_motion(legs[i].steps, {}), T_odom_start.inverse() * T_odom_end, 1e-9);
  }
}

TEST(Legs, KnowHowFastOdometryIsAtBothEnds) {
  AlignedLog log = log_of({{500, {}}, {1500, {}}});
  SE2 T_odom_base{1.0, 2.0, 3.0};
  for (int ms = 0; ms <= 2000; ms += 50) {  // ahead to the left, then back to the right
    log.T_odom_base.add(milliseconds(ms), T_odom_base);
    const double along = ms < 1000 ? 0.8 : -0.4;
    const double turn = ms < 1000 ? 0.5 : -1.0;
    T_odom_base = T_odom_base * correct_motion({{0.05 * along, 0.0, 0.05 * turn, 0.0}}, {});
  }
  const std::vector<Leg> legs = take_legs(log, kLegTrack);
  ASSERT_EQ(legs.size(), 1U);
  EXPECT_NEAR(legs[0].rate_at_start.along, 0.8, 1e-9);
  EXPECT_NEAR(legs[0].rate_at_start.turn, 0.5, 1e-9);
  EXPECT_NEAR(legs[0].rate_at_end.along, -0.4, 1e-9);
  EXPECT_NEAR(legs[0].rate_at_end.turn, -1.0, 1e-9);
}

TEST(Legs, HaveNoRateWhereOdometryBeginsOrEnds) {
  AlignedLog log = log_of({{1000, {}}, {1200, {}}, {1400, {}}});
  log.T_odom_base.add(milliseconds(1000), {});
  log.T_odom_base.add(milliseconds(1400), {0.4, 0.0, 0.0});
  const std::vector<Leg> legs = take_legs(log, kLegTrack);
  ASSERT_EQ(legs.size(), 2U);
  EXPECT_FALSE(legs[0].breaks);
  EXPECT_EQ(legs[0].rate_at_start.along, 0.0);
  EXPECT_NEAR(legs[0].rate_at_end.along, 1.0, 1e-9);
  EXPECT_NEAR(legs[1].rate_at_start.along, 1.0, 1e-9);
}

}  // namespace
}  // namespace castaway::testbed
