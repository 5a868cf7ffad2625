#include "sim/stages/odometry_sensor.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/sim/support/test_people.hpp"

namespace castaway::sim {
namespace {

using std::chrono::milliseconds;

SimulationStreams streams() {
  SimulationStreams result = test_streams(1);
  result.named = named_streams(1);
  return result;
}

/// State after `ms` of driving straight ahead at 1 m/s with exact wheels.
DriveState ahead(const SimulationConfig& config, int ms) {
  const double angle = 0.001 * ms / config.robot.wheel_radius;
  return {milliseconds(ms), {angle, angle}, 0.0, {0.001 * ms, 0.0, 0.0}, 0};
}

/// Readings every 10 ms for 3 s.
std::vector<OdometryReading> drive_measured(const SimulationConfig& config) {
  OdometrySensor sensor(config, streams());
  std::vector<OdometryReading> readings;
  for (int ms = 0; ms <= 3000; ms += 10) {
    if (const auto reading = sensor.read(ahead(config, ms))) readings.push_back(*reading);
  }
  return readings;
}

SimulationConfig with_fault(FaultKind kind) {
  SimulationConfig config = test_simulation();
  FaultSpec fault;
  fault.kind = kind;
  fault.at_s = 1.0;
  fault.for_s = 1.0;
  fault.scale = 1.5;
  config.events.faults = {fault};
  return config;
}

TEST(OdometrySensor, WithoutErrorsTellsTheWay) {
  const auto readings = drive_measured(test_simulation());
  ASSERT_EQ(readings.size(), 301U);
  EXPECT_NEAR(readings.back().T_odom_base.x, 3.0, 1e-9);
}

TEST(OdometrySensor, AFreezeLosesItsWay) {
  const auto readings = drive_measured(with_fault(FaultKind::kOdometryFrozen));
  ASSERT_EQ(readings.size(), 301U);
  EXPECT_NEAR(readings[150].T_odom_base.x, 0.99, 1e-9);  // Blocked since the previous reading.
  EXPECT_NEAR(readings.back().T_odom_base.x, 2.0, 1e-9);
}

TEST(OdometrySensor, AWrongScaleCountsTooMuchWhileItLasts) {
  EXPECT_NEAR(drive_measured(with_fault(FaultKind::kOdometryScale)).back().T_odom_base.x, 3.5,
              1e-9);
}

TEST(OdometrySensor, AReversedWheelSpinsTheRobot) {
  const SimulationConfig config = with_fault(FaultKind::kOdometryReversed);
  const auto readings = drive_measured(config);
  EXPECT_NEAR(readings[199].T_odom_base.x, 0.99, 1e-6);
  const double turn = -2.0 * 0.01 / config.robot.track;
  EXPECT_NEAR(readings[100].T_odom_base.yaw - readings[99].T_odom_base.yaw, turn, 1e-9);
}

TEST(OdometrySensor, ADropoutLosesReadingsAndNoWay) {
  const auto readings = drive_measured(with_fault(FaultKind::kOdometryDropout));
  ASSERT_EQ(readings.size(), 201U);
  EXPECT_EQ(readings[100].stamp, milliseconds(2000));
  EXPECT_NEAR(readings[100].T_odom_base.x, 2.0, 1e-9);
}

TEST(OdometrySensor, AResetStartsFromZero) {
  const auto readings = drive_measured(with_fault(FaultKind::kOdometryReset));
  EXPECT_NEAR(readings[99].T_odom_base.x, 0.99, 1e-9);
  EXPECT_NEAR(readings[100].T_odom_base.x, 0.0, 1e-9);
  EXPECT_NEAR(readings.back().T_odom_base.x, 2.0, 1e-9);
}

TEST(OdometrySensor, SlippingZonesLengthenTheWay) {
  SimulationConfig config = test_simulation();
  config.odometry.slip.zones = true;
  config.odometry.slip.zone_spread = 0.0;
  config.world.slip_zones = {{"ice", {{1.0, -1.0}, {2.0, -1.0}, {2.0, 1.0}, {1.0, 1.0}}, 0.5}};
  EXPECT_NEAR(drive_measured(config).back().T_odom_base.x, 4.0, 0.02);
}

TEST(OdometrySensor, AGyroTellsTheTurnAndWheelsTheWay) {
  SimulationConfig config = test_simulation();
  config.odometry.gyro = GyroConfig{0.0, 0.0, 0.0, 0.0};
  OdometrySensor sensor(config, streams());
  (void)sensor.read(ahead(config, 0));
  DriveState state = ahead(config, 10);
  state.turned = 0.5;  // The wheels report no rotation.
  EXPECT_NEAR(sensor.read(state)->T_odom_base.yaw, 0.5, 1e-12);
}

TEST(OdometrySensor, NeedsStreamsByNameForSlipAndGyro) {
  SimulationConfig config = test_simulation();
  config.odometry.gyro = GyroConfig{};
  EXPECT_THROW(OdometrySensor(config, test_streams(1)), std::invalid_argument);
}

}  // namespace
}  // namespace castaway::sim
