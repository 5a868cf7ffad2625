#include "sim/stages/sensor_stage.hpp"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/sim/support/test_people.hpp"

namespace castaway::sim {
namespace {

using std::chrono::milliseconds;
using std::chrono::nanoseconds;
using testing::Each;
using testing::Not;

/// The test robot at rest at its start, for a period.
Motion at_rest(const SimulationConfig& config, nanoseconds begin, nanoseconds end) {
  const Eigen::Isometry3d T_map_base = to_isometry(config.start);
  return {begin, end, T_map_base, T_map_base};
}

LidarReading scan_of(const SimFrame& frame) { return std::get<LidarReading>(frame.data); }

TEST(SensorStage, ReadsTheLidarAtItsRate) {
  const SimulationConfig config = test_simulation();
  SensorStage stage(config, test_streams(1));
  const auto scans = stage.read_lidars(stage.scene(), at_rest(config, {}, milliseconds(250)));
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
  EXPECT_EQ(frames[2].T_odom_base, Pose2{});
}

TEST(SensorStage, ReadsTheWheelsWhereTheyWereAtTheStamp) {
  const SimulationConfig config = test_simulation();
  SensorStage stage(config, test_streams(1));
  const auto frames =
      stage.read_odometry(at_rest(config, {}, milliseconds(40)), {0.0, 0.0}, {2.0, 2.0});
  const auto& third = frames[2];
  EXPECT_NEAR(third.T_odom_base.x, 0.5 * 2.0 * config.robot.wheel_radius, 1e-12);
}

TEST(SensorStage, CoveredSeesNothingAndSeesAgainAfterwards) {
  const SimulationConfig config = test_simulation();
  SensorStage stage(config, test_streams(1));
  stage.set_covered(true);
  const auto covered = stage.read_lidars(stage.scene(), at_rest(config, {}, milliseconds(100)));
  ASSERT_EQ(covered.size(), 1U);
  EXPECT_THAT(scan_of(covered[0]).ranges, Each(INFINITY));
  EXPECT_THAT(scan_of(covered[0]).hit_object, Each(kHitNothing));
  stage.set_covered(false);
  const auto seen =
      stage.read_lidars(stage.scene(), at_rest(config, milliseconds(100), milliseconds(200)));
  ASSERT_EQ(seen.size(), 1U);
  EXPECT_THAT(scan_of(seen[0]).ranges, Each(Not(INFINITY)));
}

FaultSpec fault(FaultKind kind, double at_s) {
  FaultSpec spec;
  spec.kind = kind;
  spec.at_s = at_s;
  return spec;
}

TEST(SensorStage, EveryLidarReadsAtItsOwnRate) {
  SimulationConfig config = test_simulation();
  LidarConfig rear = config.lidars.front();
  rear.name = "rear";
  rear.rate_hz = 20.0;
  rear.noise.sigma = 0.0;
  config.lidars.push_back(rear);
  SimulationStreams streams = test_streams(1);
  streams.named = named_streams(1);
  SensorStage stage(config, streams);
  const auto scans = stage.read_lidars(stage.scene(), at_rest(config, {}, milliseconds(100)));
  ASSERT_EQ(scans.size(), 3U);
  EXPECT_EQ(std::count_if(scans.begin(), scans.end(),
                          [](const SimFrame& frame) { return scan_of(frame).lidar == 1; }),
            2);
  EXPECT_EQ(stage.lidars()[1].name, "rear");
}

TEST(SensorStage, TwoLidarsOfOneNameAreAnError) {
  SimulationConfig config = test_simulation();
  config.lidars.push_back(config.lidars.front());
  EXPECT_THROW(SensorStage(config, test_streams(1)), std::invalid_argument);
}

TEST(SensorStage, LateScansComeWhenTheyAreDue) {
  SimulationConfig config = test_simulation();
  config.events.faults = {fault(FaultKind::kLidarLate, 0.0)};
  config.events.faults[0].delay_s = 0.1;
  SensorStage stage(config, test_streams(1));
  EXPECT_TRUE(stage.read_lidars(stage.scene(), at_rest(config, {}, milliseconds(150))).empty());
  const auto late =
      stage.read_lidars(stage.scene(), at_rest(config, milliseconds(150), milliseconds(250)));
  ASSERT_EQ(late.size(), 1U);
  EXPECT_EQ(scan_of(late[0]).stamp, milliseconds(0));
  EXPECT_GT(late[0].stamp, milliseconds(199));
}

TEST(SensorStage, TellsOfFaultsAtTheirTime) {
  SimulationConfig config = test_simulation();
  config.events.faults = {fault(FaultKind::kOdometryReset, 0.05)};
  SensorStage stage(config, test_streams(1));
  EXPECT_TRUE(stage.read_faults(at_rest(config, {}, milliseconds(50))).empty());
  const auto records = stage.read_faults(at_rest(config, milliseconds(50), milliseconds(60)));
  ASSERT_EQ(records.size(), 1U);
  EXPECT_EQ(records[0].T_map_base_true, config.start);
}

TEST(SensorStage, RefusesSensorsThatCannotBe) {
  SimulationConfig config = test_simulation();
  config.odometry.rate_hz = 0.0;
  EXPECT_THROW(SensorStage(config, test_streams(1)), std::invalid_argument);
  config = test_simulation();
  config.lidars.front().beams = 0;
  EXPECT_THROW(SensorStage(config, test_streams(1)), std::invalid_argument);
}

}  // namespace
}  // namespace castaway::sim
