#include "sim/navigation/mover_watch.hpp"

#include <chrono>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "sim/map/grid_tools.hpp"

namespace castaway::sim {
namespace {

using std::chrono::milliseconds;

/// 10 m x 10 m of free space centred at the origin.
Grid empty_map() { return make_grid(200, 200, 0.05, {-5.0, -5.0}, Cell::kFree); }

/// Shows the watch a person who walks from (4, 0) towards the robot at 1 m/s for two seconds, as
/// two legs that a lidar of two beams sees at 10 Hz.
void walk_past(MoverWatch& watch) {
  LiveScan live;
  for (int i = 0; i <= 20; ++i) {
    const Eigen::Vector2d left(4.0 - 0.1 * i, 0.1);
    LidarConfig lidar;
    lidar.T_base_laser.translation().z() = 0.2;
    lidar.beams = 2;
    lidar.angle_min = -std::atan2(left.y(), left.x());
    lidar.angle_increment = -2.0 * lidar.angle_min;
    LidarReading scan;
    scan.stamp = i * milliseconds(100);
    scan.ranges.assign(2, static_cast<float>(left.norm()));
    scan.hit_object.assign(2, 0);
    live.on_odometry({scan.stamp, {}, {}});
    live.on_scan(scan, lidar);
    watch.update(live, {});
  }
}

TEST(TransformMovers, TurnsPositionsAndVelocities) {
  const Pose2 T_b_a{1.0, 0.0, std::numbers::pi / 2};
  const Mover mover = transform_movers({{{2.0, 0.0}, {0.5, 0.0}}}, T_b_a).front();
  EXPECT_TRUE(mover.p.isApprox(Eigen::Vector2d(1.0, 2.0)));
  EXPECT_TRUE(mover.velocity.isApprox(Eigen::Vector2d(0.0, 0.5)));
}

TEST(MoverWatch, SeesNothingBeforeTheFirstScan) {
  MoverWatch watch(empty_map());
  LiveScan live;
  watch.update(live, {});
  EXPECT_TRUE(watch.seen().empty());
  EXPECT_TRUE(watch.velocity_at({1.0, 0.0}, {}).isZero(0.0));
}

TEST(MoverWatch, TracksWhoWalks) {
  MoverWatch watch(empty_map());
  walk_past(watch);
  ASSERT_EQ(watch.moving().size(), 1U);
  EXPECT_NEAR(watch.moving()[0].velocity.x(), -1.0, 0.2);
  EXPECT_NEAR(watch.moving()[0].p.x(), 2.0, 0.2);
  EXPECT_NEAR(watch.velocity_at({2.0, 0.1}, {}).x(), -1.0, 0.2);
  EXPECT_TRUE(watch.velocity_at({-2.0, 0.1}, {}).isZero(0.0));
}

TEST(MoverWatch, LeavesOutWhatIsOnTheMap) {
  Grid map = empty_map();
  for (int column = 120; column < 200; ++column)
    map.cells[flat_index(map, {column, 100})] = Cell::kOccupied;
  MoverWatch watch(map);
  walk_past(watch);
  EXPECT_TRUE(watch.seen().empty());
}

}  // namespace
}  // namespace castaway::sim
