#include "sim/sensor_stage.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/sim/support/test_world.hpp"

namespace castaway::sim {
namespace {

using std::chrono::milliseconds;
using std::chrono::nanoseconds;
using testing::Each;
using testing::Not;

/// The robot of the tests at its start, for a time.
Motion at_rest(const SimulationConfig& config, nanoseconds begin, nanoseconds end) {
  const Eigen::Isometry3d T_map_base = to_isometry(config.start);
  return {begin, end, T_map_base, T_map_base};
}

LidarReading scan_of(const SimFrame& frame) { return std::get<LidarReading>(frame.data); }

TEST(SensorStage, ReadsTheLidarAtItsRate) {
  const SimulationConfig config = test_simulation();
  SensorStage stage(config, test_streams(1));
  const auto scans = stage.read_lidar(stage.scene(), at_rest(config, {}, milliseconds(250)));
  ASSERT_EQ(scans.size(), 2U);
  EXPECT_EQ(scan_of(scans[1]).stamp, milliseconds(100));
  EXPECT_EQ(scans[1].stamp, milliseconds(100) + 359 * scan_of(scans[1]).time_increment);
}

TEST(SensorStage, AtRestWheelsReadZeroAtTheirRate) {
  const SimulationConfig config = test_simulation();
  SensorStage stage(config, test_streams(1));
  const auto frames = stage.read_odometry(at_rest(config, {}, milliseconds(30)), {}, {});
  ASSERT_EQ(frames.size(), 3U);
  EXPECT_EQ(frames[2].stamp, milliseconds(20));
  EXPECT_EQ(std::get<OdometryReading>(frames[2].data).T_odom_base, Pose2{});
}

TEST(SensorStage, ReadsTheWheelsWhereTheyWereAtTheStamp) {
  const SimulationConfig config = test_simulation();
  SensorStage stage(config, test_streams(1));
  const auto frames =
      stage.read_odometry(at_rest(config, {}, milliseconds(40)), {0.0, 0.0}, {2.0, 2.0});
  const auto& third = std::get<OdometryReading>(frames[2].data);
  EXPECT_NEAR(third.T_odom_base.x, 0.5 * 2.0 * config.robot.wheel_radius, 1e-12);
}

TEST(SensorStage, CoveredSeesNothingAndSeesAgainAfterwards) {
  const SimulationConfig config = test_simulation();
  SensorStage stage(config, test_streams(1));
  stage.set_covered(true);
  const auto covered = stage.read_lidar(stage.scene(), at_rest(config, {}, milliseconds(100)));
  ASSERT_EQ(covered.size(), 1U);
  EXPECT_THAT(scan_of(covered[0]).ranges, Each(INFINITY));
  EXPECT_THAT(scan_of(covered[0]).hit_object, Each(kHitNothing));
  stage.set_covered(false);
  const auto seen =
      stage.read_lidar(stage.scene(), at_rest(config, milliseconds(100), milliseconds(200)));
  ASSERT_EQ(seen.size(), 1U);
  EXPECT_THAT(scan_of(seen[0]).ranges, Each(Not(INFINITY)));
}

TEST(SensorStage, RefusesSensorsThatCannotBe) {
  SimulationConfig config = test_simulation();
  config.odometry.rate_hz = 0.0;
  EXPECT_THROW(SensorStage(config, test_streams(1)), std::invalid_argument);
  config = test_simulation();
  config.lidar.beams = 0;
  EXPECT_THROW(SensorStage(config, test_streams(1)), std::invalid_argument);
}

}  // namespace
}  // namespace castaway::sim
