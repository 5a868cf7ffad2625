#include "sim/navigation/proximity_guard.hpp"

#include <numbers>

#include <gtest/gtest.h>

namespace castaway::sim {
namespace {

constexpr float kFar = 10.0F;

/// Beams ahead, left, behind, right of base.
ProximityGuard guard_that_sees(float ahead, float left, float right) {
  LidarConfig lidar;
  lidar.T_base_laser = Eigen::Isometry3d::Identity();
  lidar.beams = 4;
  lidar.angle_min = 0.0;
  lidar.angle_increment = std::numbers::pi / 2;
  LidarReading scan;
  scan.ranges = {ahead, left, kFar, right};
  scan.hit_object = {0, 0, 0, 0};
  ProximityGuard guard(GuardConfig{});
  guard.on_scan(scan, lidar);
  return guard;
}

TEST(ProximityGuard, LetsPassWhereTheWayIsClear) {
  const Twist2 twist = guard_that_sees(kFar, kFar, kFar).guarded({0.5, 0.2});
  EXPECT_EQ(twist.v, 0.5);
  EXPECT_EQ(twist.w, 0.2);
}

TEST(ProximityGuard, BrakesAlongTheSameCurve) {
  // 0.5 m ahead of a disc of 0.25 m less a margin of 0.1 m: sqrt(2 * 0.3 * 0.15) = 0.3 m/s.
  const Twist2 twist = guard_that_sees(0.5F, kFar, kFar).guarded({0.6, 0.2});
  EXPECT_NEAR(twist.v, 0.3, 1e-6);
  EXPECT_NEAR(twist.w, 0.1, 1e-6);
}

TEST(ProximityGuard, TurnsToTheRoomierSideWhereItIsBlocked) {
  EXPECT_GT(guard_that_sees(0.3F, kFar, 0.5F).guarded({0.5, 0.0}).w, 0.0);
  EXPECT_LT(guard_that_sees(0.3F, 0.5F, kFar).guarded({0.5, 0.0}).w, 0.0);
  EXPECT_EQ(guard_that_sees(0.3F, kFar, kFar).guarded({0.5, 0.0}).v, 0.0);
}

TEST(ProximityGuard, DrivesOffBeforeItObeysAgain) {
  ProximityGuard guard = guard_that_sees(0.3F, kFar, 0.5F);
  guard.guarded({0.5, 0.0});
  LidarReading clear;
  guard.on_scan(clear, LidarConfig{});
  for (int i = 0; i < GuardConfig{}.escape_calls; ++i) {
    EXPECT_EQ(guard.guarded({0.5, -1.0}).v, GuardConfig{}.escape_speed);
  }
  EXPECT_EQ(guard.guarded({0.5, -1.0}).w, -1.0);
}

TEST(ProximityGuard, LeavesTurnsOnTheSpotAlone) {
  EXPECT_EQ(guard_that_sees(0.3F, kFar, kFar).guarded({0.0, 0.7}).w, 0.7);
}

TEST(ProximityGuard, RemembersTheNewestScanOfEachLidar) {
  ProximityGuard guard = guard_that_sees(0.3F, kFar, kFar);
  LidarReading clear;
  clear.lidar = 1;
  guard.on_scan(clear, LidarConfig{});
  EXPECT_EQ(guard.guarded({0.5, 0.0}).v, 0.0);
}

/// A beam 60 degrees down ends half its range ahead.
TEST(ProximityGuard, LaysTheBeamsOfLayersDown) {
  LidarConfig lidar;
  lidar.T_base_laser = Eigen::Isometry3d::Identity();
  lidar.beams = 1;
  lidar.angle_min = 0.0;
  lidar.elevations = {0.0, -std::numbers::pi / 3};
  LidarReading scan;
  scan.layers = 2;
  scan.ranges = {kFar, 1.0F};
  scan.hit_object = {0, 0};
  ProximityGuard guard(GuardConfig{});
  guard.on_scan(scan, lidar);
  EXPECT_NEAR(guard.guarded({0.6, 0.2}).v, 0.3, 1e-6);  // As 0.5 m ahead.
}

}  // namespace
}  // namespace castaway::sim
