#include "sim/robot/bodies/kinematic_robot.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "sim/map/grid_tools.hpp"
#include "tests/sim/support/test_world.hpp"

namespace castaway::sim {
namespace {

using std::numbers::pi;
constexpr std::chrono::nanoseconds kStep = std::chrono::milliseconds(10);
/// Practically no acceleration limit: the command holds from the first step on.
const TwistLimits kAtOnce{2.0, 2.0, 1e6, 1e6};

/// 20 m x 20 m centred at the origin, with a wall beyond x = 5.
FreeSpace floor() {
  Grid grid = make_grid(400, 400, 0.05, {-10.0, -10.0}, Cell::kFree);
  for (int row = 0; row < 400; ++row) {
    for (int column = 300; column < 302; ++column) {
      grid.cells[flat_index(grid, {column, row})] = Cell::kOccupied;
    }
  }
  return {grid, 0.2};
}

KinematicRobot kinematic_at(const Pose2& start, const TwistLimits& limits = kAtOnce) {
  return {test_robot(), floor(), start, limits, kStep};
}

Pose2 pose_of(const KinematicRobot& robot) { return to_planar(robot.state().T_map_base); }

void run(KinematicRobot& robot, const Twist2& command, int steps) {
  robot.set_command(command);
  for (int i = 0; i < steps; ++i) robot.step();
}

TEST(KinematicRobot, DrivesStraightLinesTurnsAndArcsExactly) {
  KinematicRobot straight = kinematic_at({0.0, 0.0, 0.5});
  run(straight, {0.4, 0.0}, 500);
  EXPECT_NEAR(pose_of(straight).x, 2.0 * std::cos(0.5), 1e-9);
  EXPECT_NEAR(pose_of(straight).y, 2.0 * std::sin(0.5), 1e-9);
  KinematicRobot turning = kinematic_at({1.0, 2.0, 0.0});
  run(turning, {0.0, 0.5}, 200);
  EXPECT_NEAR(pose_of(turning).yaw, 1.0, 1e-9);
  EXPECT_NEAR(pose_of(turning).x, 1.0, 1e-9);
  KinematicRobot circle = kinematic_at({0.0, 0.0, 0.0});
  run(circle, {0.5, 0.5}, 200);  // 1 rad of a circle of radius 1 m
  EXPECT_NEAR(pose_of(circle).x, std::sin(1.0), 1e-9);
  EXPECT_NEAR(pose_of(circle).y, 1.0 - std::cos(1.0), 1e-9);
}

TEST(KinematicRobot, TurnsAboutTheMiddleOfItsAxle) {
  RobotModel model = test_robot();
  model.p_base_axle = {-0.1, 0.0};
  KinematicRobot robot(model, floor(), {0.0, 0.0, 0.0}, kAtOnce, kStep);
  run(robot, {0.0, 1.0}, 157);
  const double turned = 1.57;
  EXPECT_NEAR(pose_of(robot).x, -0.1 + 0.1 * std::cos(turned), 1e-9);
  EXPECT_NEAR(pose_of(robot).y, 0.1 * std::sin(turned), 1e-9);
}

TEST(KinematicRobot, TurnsAboutBaseWhereItsAxleIsToOneSide) {
  RobotModel model = test_robot();
  model.p_base_axle = {0.0, -0.1};
  KinematicRobot robot(model, floor(), {0.0, 0.0, 0.0}, kAtOnce, kStep);
  run(robot, {0.0, 1.0}, 157);
  EXPECT_NEAR(pose_of(robot).position().norm(), 0.0, 1e-9);
  EXPECT_NEAR(pose_of(robot).yaw, 1.57, 1e-9);
}

TEST(KinematicRobot, TurnsItsWheelsAsItMoves) {
  KinematicRobot robot = kinematic_at({});
  run(robot, {0.5, 0.5}, 100);
  EXPECT_NEAR(robot.state().wheels.left, (0.5 - 0.5 * 0.287 * 0.5) / 0.033, 1e-9);
  EXPECT_NEAR(robot.state().wheels.right, (0.5 + 0.5 * 0.287 * 0.5) / 0.033, 1e-9);
}

TEST(KinematicRobot, RampsItsSpeed) {
  KinematicRobot robot = kinematic_at({}, {1.0, 1.0, 0.5, 1.0});
  run(robot, {1.0, 0.0}, 200);  // 0.5 m/s^2 for 2 s
  EXPECT_NEAR(pose_of(robot).x, 1.0, 0.01);
}

TEST(KinematicRobot, StopsAtAWallCountsItAndComesOffAgain) {
  KinematicRobot robot = kinematic_at({4.0, 0.0, 0.0});
  run(robot, {0.5, 0.0}, 400);
  EXPECT_NEAR(pose_of(robot).x, 4.8, 0.06);
  EXPECT_EQ(robot.collisions(), 1);
  const double wheels = robot.state().wheels.left;
  run(robot, {0.5, 0.0}, 100);
  EXPECT_EQ(robot.state().wheels.left, wheels);
  EXPECT_EQ(robot.collisions(), 1);
  run(robot, {-0.5, 0.0}, 200);
  EXPECT_NEAR(pose_of(robot).x, 3.8, 0.07);
  run(robot, {0.5, 0.0}, 400);
  EXPECT_EQ(robot.collisions(), 2);
}

TEST(KinematicRobot, LeavesTheMarginOfAnObstacleItWasPutInto) {
  KinematicRobot robot = kinematic_at({4.9, 0.0, pi});
  run(robot, {0.5, 0.0}, 200);
  EXPECT_NEAR(pose_of(robot).x, 3.9, 1e-6);
  EXPECT_EQ(robot.collisions(), 0);
}

TEST(KinematicRobot, IsHeldWithItsWheelsInTheAir) {
  KinematicRobot robot = kinematic_at({});
  robot.set_command({0.5, 0.0});
  Eigen::Isometry3d T_map_base = to_isometry({1.0, 2.0, 0.3});
  T_map_base.translation().z() = 0.4;
  robot.step_held(T_map_base, HeldWheels::kDriven);
  EXPECT_TRUE(robot.state().T_map_base.isApprox(T_map_base));
  EXPECT_NEAR(robot.state().wheels.left, 0.5 * 0.01 / 0.033, 1e-9);
  const double wheels = robot.state().wheels.left;
  robot.step_held(T_map_base, HeldWheels::kLocked);
  EXPECT_EQ(robot.state().wheels.left, wheels);
  robot.teleport({3.0, 1.0, 0.0});
  EXPECT_EQ(robot.state().T_map_base.translation().z(), 0.0);
}

}  // namespace
}  // namespace castaway::sim
