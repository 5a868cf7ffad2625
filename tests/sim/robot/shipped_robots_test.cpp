// Every robot of robots/ loads without a warning, and odometry by its parameters stays close to the
// truth while it drives straight, turns on the spot, drives arcs and stands.
#include <cmath>
#include <map>
#include <numbers>

#include <gtest/gtest.h>

#include "sim/robot/bodies/robot_physics.hpp"
#include "sim/robot/load_robot.hpp"
#include "sim/robot/robot_sensors.hpp"
#include "tests/support/robot_files.hpp"

namespace castaway::sim {
namespace {

using std::numbers::pi;
constexpr int kStepsPerSecond = 500;

/// Values from the robot's README.md, and tolerances of odometry.
struct Expected {
  const char* file;
  std::size_t wheels;
  double radius;      ///< [m]
  double separation;  ///< [m]
  std::size_t casters;
  std::size_t lidars;
  double way_error;     ///< [m] After 20 m straight ahead.
  double turn_error;    ///< [rad] After two turns on the spot, and after the course.
  double course_error;  ///< [m] After 6 m with eight turns.
};

std::ostream& operator<<(std::ostream& out, const Expected& e) { return out << e.file; }

RobotModel load_shipped(const Expected& expected) {
  return load_robot(std::string(CASTAWAY_ROBOTS "/") + expected.file);
}

/// A robot on an empty floor with ideal odometry.
class TestDrive {
 public:
  explicit TestDrive(const RobotModel& robot)
      : physics_(floor(), robot, {}, {0.5, 1.0, 0.5, 2.0}, std::chrono::milliseconds(2)),
        odometry_(ideal_odometry(), drive_geometry(robot), rng_) {}

  void run(const Twist2& command, double seconds) {
    physics_.set_command(command);
    for (int i = 0; i < static_cast<int>(seconds * kStepsPerSecond); ++i) {
      physics_.step();
      odometry_.update(physics_.state().wheels, rng_);
      tilt_ = std::max(tilt_, std::acos(std::min(1.0, physics_.state().T_map_base.linear()(2, 2))));
    }
  }
  [[nodiscard]] Pose2 truth() const { return to_planar(physics_.state().T_map_base); }
  [[nodiscard]] double position_error() const {
    return (truth().position() - odometry_.T_odom_base().position()).norm();
  }
  [[nodiscard]] double yaw_error() const {
    return std::abs(wrap_angle(truth().yaw - odometry_.T_odom_base().yaw));
  }
  [[nodiscard]] double worst_tilt() const { return tilt_; }

 private:
  static WorldSpec floor() {
    WorldSpec world;
    world.min_corner = {-30.0, -30.0};
    world.max_corner = {30.0, 30.0};
    return world;
  }

  Rng rng_;
  RobotPhysics physics_;
  WheelOdometry odometry_;
  double tilt_ = 0.0;
};

class ShippedRobot : public testing::TestWithParam<Expected> {
 protected:
  void record(const std::string& what, const TestDrive& drive) const {
    RecordProperty(what + "_position_um", static_cast<int>(1e6 * drive.position_error()));
    RecordProperty(what + "_yaw_urad", static_cast<int>(1e6 * drive.yaw_error()));
  }
};

TEST_P(ShippedRobot, IsUnderstoodWithoutAWarning) {
  const Expected& expected = GetParam();
  const RobotModel robot = load_shipped(expected);
  EXPECT_TRUE(robot.warnings.empty()) << robot.warnings.front();
  EXPECT_EQ(robot.wheels.size(), expected.wheels);
  EXPECT_NEAR(robot.wheel_radius, expected.radius, 1e-9);
  EXPECT_NEAR(robot.wheel_separation, expected.separation, 1e-9);
  EXPECT_EQ(robot.casters.size(), expected.casters);
  EXPECT_EQ(robot.lidars.size(), expected.lidars);
}

TEST_P(ShippedRobot, DrivesStraight) {
  TestDrive drive(load_shipped(GetParam()));
  drive.run({0.25, 0.0}, 80.0);
  record("straight", drive);
  EXPECT_GT(drive.truth().x, 19.0);
  EXPECT_LT(std::abs(drive.truth().y), 0.1);
  EXPECT_LT(drive.position_error(), GetParam().way_error);
  EXPECT_LT(drive.worst_tilt(), 0.01);
}

TEST_P(ShippedRobot, TurnsOnTheSpot) {
  TestDrive drive(load_shipped(GetParam()));
  drive.run({0.0, 0.8}, 4.0 * pi / 0.8);
  drive.run({0.0, 0.0}, 1.0);
  record("turn", drive);
  EXPECT_LT(drive.yaw_error(), GetParam().turn_error);
  EXPECT_LT(drive.truth().position().norm(), 0.02);
}

TEST_P(ShippedRobot, DrivesArcsAndASquare) {
  TestDrive drive(load_shipped(GetParam()));
  for (int edge = 0; edge < 4; ++edge) {
    drive.run({0.25, 0.0}, 4.0);
    drive.run({0.25, 0.5}, 2.0);
    drive.run({0.0, 0.0}, 1.0);
    drive.run({0.0, -0.5}, 2.0);
    drive.run({0.0, 0.0}, 1.0);
  }
  record("course", drive);
  EXPECT_LT(drive.position_error(), GetParam().course_error);
  EXPECT_LT(drive.yaw_error(), GetParam().turn_error);
}

TEST_P(ShippedRobot, StandsStill) {
  TestDrive drive(load_shipped(GetParam()));
  drive.run({}, 10.0);
  EXPECT_LT(drive.truth().position().norm(), 5e-4);
  EXPECT_LT(std::abs(drive.truth().yaw), 1e-3);
}

INSTANTIATE_TEST_SUITE_P(
    Robots, ShippedRobot,
    testing::Values(Expected{"waffle/waffle.urdf", 2, 0.033, 0.287, 2, 1, 0.001, 0.001, 0.001},
                    Expected{"disc/disc.urdf", 2, 0.036, 0.233, 1, 1, 0.001, 0.001, 0.001},
                    Expected{"butler/butler.urdf.xacro", 2, 0.100, 0.400, 4, 2, 0.002, 0.001,
                             0.002},
                    Expected{"mule/mule.urdf.xacro", 4, 0.100, 0.400, 0, 1, 0.01, 0.15, 0.6}));

}  // namespace
}  // namespace castaway::sim
