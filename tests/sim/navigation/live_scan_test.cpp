#include "sim/navigation/live_scan.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

namespace castaway::sim {
namespace {

using std::chrono::milliseconds;

/// A lidar in base with four beams: forward, left, backward, right.
LidarConfig cross() {
  LidarConfig lidar;
  lidar.T_base_laser = Eigen::Translation3d(0.0, 0.0, 0.2) * Eigen::Isometry3d::Identity();
  lidar.beams = 4;
  lidar.angle_min = 0.0;
  lidar.angle_increment = std::numbers::pi / 2;
  return lidar;
}

LidarReading scan_at(milliseconds stamp, std::vector<float> ranges) {
  LidarReading scan;
  scan.stamp = stamp;
  scan.hit_object.assign(ranges.size(), 0);
  scan.ranges = std::move(ranges);
  return scan;
}

TEST(LiveScan, CarriesEndPointsAlongAsTheRobotMoves) {
  LiveScan live;
  live.on_odometry({milliseconds(0), {5.0, 1.0, 0.0}, {}});
  live.on_odometry({milliseconds(100), {5.5, 1.0, 0.0}, {}});
  live.on_scan(scan_at(milliseconds(0), {2.0F, 1.0F, 3.0F, 4.0F}), cross());
  const auto points = live.p_base();
  ASSERT_EQ(points.size(), 4U);
  EXPECT_NEAR((points[0] - Eigen::Vector2d(1.5, 0.0)).norm(), 0.0, 1e-6);
  EXPECT_NEAR((points[1] - Eigen::Vector2d(-0.5, 1.0)).norm(), 0.0, 1e-6);
  live.on_odometry({milliseconds(200), {5.5, 1.0, std::numbers::pi / 2}, {}});
  EXPECT_NEAR((live.p_base()[0] - Eigen::Vector2d(0.0, -1.5)).norm(), 0.0, 1e-6);
  EXPECT_EQ(live.T_odom_base().yaw, std::numbers::pi / 2);
}

TEST(LiveScan, LeavesOutWhatIsNoObstacle) {
  LiveScan live;
  const float inf = std::numeric_limits<float>::infinity();
  live.on_scan(scan_at(milliseconds(0), {inf, -inf, NAN, 4.0F}), cross());
  EXPECT_EQ(live.p_base().size(), 1U);
  LidarConfig tilted = cross();
  tilted.T_base_laser.rotate(Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitY()));
  live.on_scan(scan_at(milliseconds(0), {2.0F, 1.0F, 1.0F, 1.0F}), tilted);
  EXPECT_EQ(live.p_base().size(), 3U);  // the forward beam hits the floor
}

TEST(LiveScan, RemembersTheNewestScanOfEachLidar) {
  LiveScan live;
  live.on_scan(scan_at(milliseconds(0), {2.0F, 1.0F, 3.0F, 4.0F}), cross());
  LidarReading other = scan_at(milliseconds(50), {5.0F, NAN, NAN, NAN});
  other.lidar = 1;
  live.on_scan(other, cross());
  EXPECT_EQ(live.p_base().size(), 5U);
  live.on_scan(scan_at(milliseconds(100), {2.0F, NAN, NAN, NAN}), cross());
  EXPECT_EQ(live.p_base().size(), 2U);
}

/// A beam 60 degrees up is projected to half its range.
TEST(LiveScan, LaysTheBeamsOfLayersDown) {
  LidarConfig lidar = cross();
  lidar.beams = 1;
  lidar.elevations = {0.0, std::numbers::pi / 3};
  LidarReading scan = scan_at(milliseconds(0), {4.0F, 1.0F});
  scan.layers = 2;
  LiveScan live;
  live.on_scan(scan, lidar);
  const auto points = live.p_base();
  ASSERT_EQ(points.size(), 2U);
  EXPECT_NEAR(points[1].x(), 0.5, 1e-6);
}

/// Each beam starts where the robot was when the beam was emitted.
TEST(LiveScan, TakesEachBeamFromItsOwnPlace) {
  LiveScan live;
  for (int i = 0; i <= 4; ++i) {
    live.on_odometry({milliseconds(25 * i), {0.1 * i, 0.0, 0.0}, {}});
  }
  LidarReading scan = scan_at(milliseconds(0), {2.0F, 1.0F, 3.0F, 4.0F});
  scan.time_increment = milliseconds(25);
  live.on_scan(scan, cross());
  const auto news = live.take_new_scans();
  ASSERT_EQ(news.size(), 1U);
  ASSERT_EQ(news[0].size(), 4U);
  EXPECT_NEAR(news[0][0].p.x(), 2.0, 1e-6);
  EXPECT_NEAR(news[0][2].p.x(), 0.2 - 3.0, 1e-6);
  EXPECT_EQ(news[0][2].stamp, milliseconds(50));
  EXPECT_NEAR(live.p_base()[0].x(), 2.0 - 0.4, 1e-6);
}

TEST(LiveScan, HandsEachScanOutOnce) {
  LiveScan live;
  EXPECT_TRUE(live.take_new_scans().empty());
  live.on_scan(scan_at(milliseconds(0), {2.0F, 1.0F, 3.0F, 4.0F}), cross());
  LidarReading other = scan_at(milliseconds(0), {5.0F, NAN, NAN, NAN});
  other.lidar = 1;
  live.on_scan(other, cross());
  EXPECT_EQ(live.take_new_scans().size(), 2U);
  EXPECT_TRUE(live.take_new_scans().empty());
}

TEST(LiveScan, TellsTheSpeedFromOdometry) {
  LiveScan live;
  EXPECT_EQ(live.twist().v, 0.0);
  for (int i = 0; i <= 10; ++i) {
    live.on_odometry({milliseconds(10 * i), {0.004 * i, 0.0, 0.002 * i}, {}});
  }
  EXPECT_NEAR(live.twist().v, 0.4, 1e-3);
  EXPECT_NEAR(live.twist().w, 0.2, 1e-9);
  EXPECT_EQ(live.stamp(), milliseconds(100));
}

TEST(LiveScan, KnowsNothingBeforeTheFirstScan) {
  const LiveScan live;
  EXPECT_TRUE(live.p_base().empty());
  EXPECT_EQ(live.T_odom_base(), Pose2{});
}

}  // namespace
}  // namespace castaway::sim
