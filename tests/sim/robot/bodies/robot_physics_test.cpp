#include "sim/robot/bodies/robot_physics.hpp"

#include <cmath>
#include <numbers>
#include <optional>

#include <gtest/gtest.h>

#include "sim/robot/load_robot.hpp"
#include "sim/robot/robot_sensors.hpp"
#include "tests/sim/support/test_world.hpp"

namespace castaway::sim {
namespace {

using std::numbers::pi;
constexpr std::chrono::nanoseconds kPhysicsStep = std::chrono::milliseconds(2);
const TwistLimits kLimits{0.5, 1.0, 0.5, 2.0};

WorldSpec open_floor() {
  WorldSpec world;
  world.min_corner = {-10.0, -10.0};
  world.max_corner = {10.0, 10.0};
  return world;
}

/// Error of ideal odometry after an open-loop square.
struct SquareError {
  double position = 0.0;    ///< [m]
  double yaw = 0.0;         ///< [rad]
  double way = 0.0;         ///< [m]
  double worst_tilt = 0.0;  ///< [rad]
};

double tilt(const RobotState& state) {
  return std::acos(std::min(1.0, state.T_map_base.linear()(2, 2)));
}

SquareError drive_square(const RobotModel& robot, double side) {
  RobotPhysics physics(open_floor(), robot, {}, kLimits, kPhysicsStep);
  Rng rng;
  WheelOdometry odometry(ideal_odometry(), drive_geometry(robot), rng);
  SquareError error;
  const auto run = [&](const Twist2& command, double seconds) {
    physics.set_command(command);
    for (int i = 0; i < static_cast<int>(seconds * 500.0); ++i) {
      const Eigen::Vector3d before = physics.state().T_map_base.translation();
      physics.step();
      odometry.update(physics.state().wheels, rng);
      error.way += (physics.state().T_map_base.translation() - before).norm();
      error.worst_tilt = std::max(error.worst_tilt, tilt(physics.state()));
    }
  };
  for (int edge = 0; edge < 4; ++edge) {
    run({0.5, 0.0}, side / 0.5);
    run({0.0, 0.0}, 1.5);
    run({0.0, 1.0}, 0.5 * pi);
    run({0.0, 0.0}, 1.0);
  }
  const Pose2 truth = to_planar(physics.state().T_map_base);
  const Pose2 odom = odometry.T_odom_base();
  error.position = std::hypot(truth.x - odom.x, truth.y - odom.y);
  error.yaw = std::abs(wrap_angle(truth.yaw - odom.yaw));
  return error;
}

class SquareOf : public testing::TestWithParam<const char*> {};

TEST_P(SquareOf, TwentyMetresLeavesLessThanACentimetre) {
  const RobotModel robot = load_robot(GetParam());
  const SquareError error = drive_square(robot, 5.0);
  EXPECT_GT(error.way, 9.0);
  EXPECT_LT(error.position, 0.01);
  EXPECT_LT(error.yaw, 0.01);
  EXPECT_LT(error.worst_tilt, 0.01);
  RecordProperty("position_error_um", static_cast<int>(1e6 * error.position));
  RecordProperty("yaw_error_urad", static_cast<int>(1e6 * error.yaw));
}

INSTANTIATE_TEST_SUITE_P(Robots, SquareOf,
                         testing::Values(CASTAWAY_ROBOTS "/waffle/waffle.urdf",
                                         CASTAWAY_TEST_DATA "/robots/burger_like.urdf",
                                         CASTAWAY_TEST_DATA "/robots/create_like.urdf",
                                         CASTAWAY_TEST_DATA "/robots/pioneer_like.urdf"));

TEST(RobotPhysics, RampsUpAndReachesTheCommand) {
  RobotPhysics physics(open_floor(), test_robot(), {}, kLimits, kPhysicsStep);
  physics.set_command({0.4, 0.0});
  for (int i = 0; i < 400; ++i) physics.step();  // 0.8 s of acceleration at 0.5 m/s^2.
  EXPECT_NEAR(to_planar(physics.state().T_map_base).x, 0.16, 0.005);
  for (int i = 0; i < 500; ++i) physics.step();
  EXPECT_NEAR(to_planar(physics.state().T_map_base).x, 0.56, 0.005);
}

TEST(RobotPhysics, TurnsCounterClockwiseForPositiveRates) {
  RobotPhysics physics(open_floor(), test_robot(), {}, kLimits, kPhysicsStep);
  physics.set_command({0.0, 1.0});
  for (int i = 0; i < 750; ++i) physics.step();
  EXPECT_NEAR(to_planar(physics.state().T_map_base).yaw, 1.25, 0.02);
  EXPECT_GT(physics.state().wheels.right, 1.0);
  EXPECT_LT(physics.state().wheels.left, -1.0);
}

TEST(RobotPhysics, StandsStill) {
  RobotPhysics physics(open_floor(), test_robot(), {1.0, 2.0, 0.5}, kLimits, kPhysicsStep);
  for (int i = 0; i < 5000; ++i) physics.step();
  const Pose2 pose = to_planar(physics.state().T_map_base);
  EXPECT_NEAR(pose.x, 1.0, 1e-4);
  EXPECT_NEAR(pose.y, 2.0, 1e-4);
  EXPECT_NEAR(pose.yaw, 0.5, 1e-4);
  EXPECT_NEAR(physics.state().T_map_base.translation().z(), 0.0, 1e-3);
}

TEST(RobotPhysics, TeleportMovesTheTruthAndNothingElse) {
  RobotPhysics physics(open_floor(), test_robot(), {}, kLimits, kPhysicsStep);
  physics.set_command({0.4, 0.5});
  for (int i = 0; i < 1000; ++i) physics.step();
  const WheelAngles before = physics.state().wheels;
  physics.teleport({-3.0, 4.0, 2.0});
  const Pose2 pose = to_planar(physics.state().T_map_base);
  EXPECT_NEAR(pose.x, -3.0, 1e-12);
  EXPECT_NEAR(pose.y, 4.0, 1e-12);
  EXPECT_NEAR(pose.yaw, 2.0, 1e-12);
  EXPECT_NEAR(physics.state().wheels.left, before.left, 1e-9);
  EXPECT_NEAR(physics.state().wheels.right, before.right, 1e-9);
  physics.set_command({});
  for (int i = 0; i < 500; ++i) physics.step();
  EXPECT_NEAR(to_planar(physics.state().T_map_base).x, -3.0, 1e-3);
  EXPECT_NEAR(to_planar(physics.state().T_map_base).y, 4.0, 1e-3);
}

TEST(RobotPhysics, CountsARunIntoAWallOnce) {
  WorldSpec world = open_floor();
  world.objects = {box_on_floor("wall", {0.2, 4.0, 1.0}, {1.1, 0.0})};
  RobotPhysics physics(world, test_robot(), {}, kLimits, kPhysicsStep);
  physics.set_command({0.4, 0.0});
  for (int i = 0; i < 3000; ++i) physics.step();
  EXPECT_EQ(physics.collisions(), 1);
  EXPECT_LT(to_planar(physics.state().T_map_base).x, 1.0);
}

TEST(RobotPhysics, MeshesStopItToo) {
  WorldSpec world = open_floor();
  WorldObject cube;
  cube.shape = MeshShape{CASTAWAY_TEST_DATA "/meshes/cube.obj", Eigen::Vector3d::Ones()};
  cube.T_map_object = Eigen::Translation3d(1.5, 0.0, 0.5);
  world.objects = {cube};
  RobotPhysics physics(world, test_robot(), {}, kLimits, kPhysicsStep);
  physics.set_command({0.4, 0.0});
  for (int i = 0; i < 3000; ++i) physics.step();
  EXPECT_EQ(physics.collisions(), 1);
  EXPECT_LT(to_planar(physics.state().T_map_base).x, 1.0);
}

TEST(RobotPhysics, AMeshForABodyCollidesAsItsHull) {
  WorldSpec world = open_floor();
  world.objects = {box_on_floor("wall", {0.2, 4.0, 1.0}, {1.1, 0.0})};
  RobotModel robot = test_robot();
  robot.collisions[0].shape =
      MeshShape{CASTAWAY_ROBOTS "/waffle/meshes/base.obj", Eigen::Vector3d::Ones()};
  robot.collisions[0].T_base_part = Eigen::Translation3d(0.0, 0.0, 0.01);
  RobotPhysics physics(world, robot, {}, kLimits, kPhysicsStep);
  physics.set_command({0.3, 0.0});
  for (int i = 0; i < 3000; ++i) physics.step();
  EXPECT_EQ(physics.collisions(), 1);
  EXPECT_NEAR(to_planar(physics.state().T_map_base).x, 1.0 - 0.069, 0.01);
}

TEST(RobotPhysics, ManyBoxesStopItLikeFew) {
  WorldSpec world = open_floor();
  for (int i = 0; i < 400; ++i) {
    world.objects.push_back(
        box_on_floor("brick", {0.05, 0.05, 1.0}, {1.0 + 0.05 * (i / 80), 0.05 * (i % 80) - 2.0}));
  }
  RobotPhysics physics(world, test_robot(), {}, kLimits, kPhysicsStep);
  physics.set_command({0.4, 0.0});
  for (int i = 0; i < 3000; ++i) physics.step();
  EXPECT_EQ(physics.collisions(), 1);
  EXPECT_NEAR(to_planar(physics.state().T_map_base).x, 0.975 - 0.069, 0.01);
}

TEST(RobotPhysics, KeepsTheCurveWhereWheelsAreTooSlow) {
  RobotModel robot = test_robot();
  for (DriveWheel& wheel : robot.wheels) wheel.speed_max = 6.0;  // 0.2 m/s.
  RobotPhysics physics(open_floor(), robot, {}, kLimits, kPhysicsStep);
  physics.set_command({0.4, 0.4});  // A circle of 1 m.
  for (int i = 0; i < 1000; ++i) physics.step();
  const WheelAngles before = physics.state().wheels;
  for (int i = 0; i < 1000; ++i) physics.step();
  const WheelAngles after = physics.state().wheels;
  EXPECT_NEAR(after.right - before.right, 12.0, 0.05);
  EXPECT_NEAR((after.right - before.right) / (after.left - before.left),
              (1.0 + 0.5 * robot.track) / (1.0 - 0.5 * robot.track), 0.005);
}

}  // namespace
}  // namespace castaway::sim
