#include "sim/robot/bodies/path_robot.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/sim/support/test_world.hpp"

namespace castaway::sim {
namespace {

constexpr std::chrono::nanoseconds kPathStep = std::chrono::milliseconds(10);
constexpr double kPathRadius = 0.033;  // [m] Of the wheels of `test_robot`.
constexpr double kPathTrack = 0.287;   // [m]

const std::vector<TimedPose> kCorner = {
    {0.0, {1.0, 2.0, 0.0}}, {2.0, {3.0, 2.0, 0.0}}, {3.0, {3.0, 2.0, 0.5}}};

PathRobot path_robot(const std::vector<TimedPose>& path) { return {test_robot(), path, kPathStep}; }

Pose2 planar_pose(const PathRobot& robot) { return to_planar(robot.state().T_map_base); }

void step_for(PathRobot& robot, int steps) {
  for (int i = 0; i < steps; ++i) robot.step();
}

/// The state after a straight motion from one pose to another within 1 s.
RobotState state_after(const Pose2& from, const Pose2& to) {
  PathRobot robot = path_robot({{0.0, from}, {1.0, to}});
  step_for(robot, 100);
  return robot.state();
}

void expect_pose(const Pose2& pose, const Pose2& expected, double tolerance = 1e-12) {
  EXPECT_NEAR(pose.x, expected.x, tolerance);
  EXPECT_NEAR(pose.y, expected.y, tolerance);
  EXPECT_NEAR(wrap_angle(pose.yaw - expected.yaw), 0.0, tolerance);
}

void expect_wheels(const RobotState& state, double left_m, double right_m,
                   double tolerance = 1e-9) {
  EXPECT_NEAR(state.wheels.left, left_m / kPathRadius, tolerance);
  EXPECT_NEAR(state.wheels.right, right_m / kPathRadius, tolerance);
}

TEST(PoseAt, IsLinearBetweenPoses) {
  expect_pose(pose_at(kCorner, 0.5), {1.5, 2.0, 0.0});
  expect_pose(pose_at(kCorner, 2.0), {3.0, 2.0, 0.0});
  expect_pose(pose_at(kCorner, 2.2), {3.0, 2.0, 0.1});
  const std::vector<TimedPose> slanted = {{1.0, {1.0, -1.0, 0.2}}, {5.0, {-1.0, 1.0, -0.2}}};
  expect_pose(pose_at(slanted, 4.0), {-0.5, 0.5, -0.1});
}

TEST(PoseAt, StaysAtTheEnds) {
  EXPECT_EQ(pose_at(kCorner, -1.0), kCorner.front().T_map_base);
  EXPECT_EQ(pose_at(kCorner, 0.0), kCorner.front().T_map_base);
  EXPECT_EQ(pose_at(kCorner, 3.0), kCorner.back().T_map_base);
  EXPECT_EQ(pose_at(kCorner, 100.0), kCorner.back().T_map_base);
  const std::vector<TimedPose> one = {{1.0, {4.0, 5.0, 6.0}}};
  EXPECT_EQ(pose_at(one, 0.0), one.front().T_map_base);
  EXPECT_EQ(pose_at(one, 1.0), one.front().T_map_base);
  EXPECT_EQ(pose_at(one, 2.0), one.front().T_map_base);
}

TEST(PoseAt, TakesTheShorterTurn) {
  const std::vector<TimedPose> left = {{0.0, {0.0, 0.0, 3.0}}, {1.0, {0.0, 0.0, -3.0}}};
  const double turn = 2.0 * std::numbers::pi - 6.0;
  expect_pose(pose_at(left, 0.25), {0.0, 0.0, 3.0 + 0.25 * turn});
  expect_pose(pose_at(left, 0.75), {0.0, 0.0, 3.0 + 0.75 * turn});
  const std::vector<TimedPose> right = {{0.0, {0.0, 0.0, -3.0}}, {1.0, {0.0, 0.0, 3.0}}};
  expect_pose(pose_at(right, 0.25), {0.0, 0.0, -3.0 - 0.25 * turn});
  EXPECT_LE(std::abs(pose_at(right, 0.75).yaw), std::numbers::pi);
}

TEST(PathRobot, BeginsAtTheFirstPose) {
  const PathRobot robot = path_robot(kCorner);
  expect_pose(planar_pose(robot), {1.0, 2.0, 0.0});
  expect_wheels(robot.state(), 0.0, 0.0);
  EXPECT_EQ(robot.state().T_map_base.translation().z(), 0.0);
  const PathRobot late = path_robot({{5.0, {7.0, 8.0, 0.3}}, {6.0, {8.0, 8.0, 0.3}}});
  expect_pose(planar_pose(late), {7.0, 8.0, 0.3});
}

TEST(PathRobot, IsWhereThePathIs) {
  PathRobot robot = path_robot(kCorner);
  for (int i = 1; i <= 400; ++i) {
    robot.step();
    expect_pose(planar_pose(robot), pose_at(kCorner, 0.01 * i), 1e-9);
  }
  expect_pose(planar_pose(robot), {3.0, 2.0, 0.5});  // it stays at the end
}

TEST(PathRobot, RollsItsWheelsAlike) {
  expect_wheels(state_after({0.0, 0.0, 0.0}, {2.0, 0.0, 0.0}), 2.0, 2.0);
  expect_wheels(state_after({1.0, 1.0, 0.5}, {1.0 - std::cos(0.5), 1.0 - std::sin(0.5), 0.5}), -1.0,
                -1.0);
}

TEST(PathRobot, TurnsItsWheelsAgainstEachOtherOnTheSpot) {
  const double rim = 0.5 * kPathTrack * 1.5;
  expect_wheels(state_after({1.0, 2.0, 0.0}, {1.0, 2.0, 1.5}), -rim, rim);
  expect_wheels(state_after({1.0, 2.0, 0.0}, {1.0, 2.0, -1.5}), rim, -rim);
  const double over_pi = 0.5 * kPathTrack * (2.0 * std::numbers::pi - 6.0);
  expect_wheels(state_after({1.0, 2.0, 3.0}, {1.0, 2.0, -3.0}), -over_pi, over_pi);
}

TEST(PathRobot, RollsTheOuterWheelFartherInAnArc) {
  constexpr double kRadius = 2.0;  // [m] Around a centre to the left.
  std::vector<TimedPose> path;
  for (int i = 0; i <= 1000; ++i) {
    const double angle = 0.001 * i;
    path.push_back(
        {0.01 * i, {kRadius * std::sin(angle), kRadius * (1.0 - std::cos(angle)), angle}});
  }
  PathRobot left = path_robot(path);
  step_for(left, 1000);
  expect_wheels(left.state(), kRadius - 0.5 * kPathTrack, kRadius + 0.5 * kPathTrack, 1e-4);
  for (TimedPose& pose : path) {
    pose.T_map_base = {pose.T_map_base.x, -pose.T_map_base.y, -pose.T_map_base.yaw};
  }
  PathRobot right = path_robot(path);
  step_for(right, 1000);
  expect_wheels(right.state(), kRadius + 0.5 * kPathTrack, kRadius - 0.5 * kPathTrack, 1e-4);
}

TEST(PathRobot, DoesNotTurnItsWheelsAcross) {
  expect_wheels(state_after({0.0, 0.0, 0.0}, {0.0, 1.5, 0.0}), 0.0, 0.0);
  expect_wheels(state_after({0.0, 0.0, 0.5 * std::numbers::pi}, {1.5, 0.0, 0.5 * std::numbers::pi}),
                0.0, 0.0);
  expect_wheels(state_after({0.0, 0.0, 0.0}, {1.0, 1.5, 0.0}), 1.0, 1.0);
}

TEST(PathRobot, TurnsItsWheelsByTheMotionOfTheAxle) {
  RobotModel model = test_robot();
  model.p_base_axle = {-0.1, 0.0};
  std::vector<TimedPose> path;  // base swings about an axle that stands
  for (int i = 0; i <= 100; ++i) {
    const double yaw = 0.01 * i;
    path.push_back({0.01 * i, {0.1 * std::cos(yaw), 0.1 * std::sin(yaw), yaw}});
  }
  PathRobot robot(model, path, kPathStep);
  step_for(robot, 100);
  expect_wheels(robot.state(), -0.5 * kPathTrack, 0.5 * kPathTrack);
}

TEST(PathRobot, IsStoppedByNothing) {
  PathRobot robot = path_robot({{0.0, {0.0, 0.0, 0.0}}, {1.0, {1000.0, 0.0, 0.0}}});
  robot.set_command({-5.0, 3.0});
  step_for(robot, 100);
  expect_pose(planar_pose(robot), {1000.0, 0.0, 0.0}, 1e-9);
  EXPECT_EQ(robot.collisions(), 0);
  EXPECT_FALSE(robot.touching());
}

TEST(PathRobot, GoesOnFromItsPathAfterItWasHeld) {
  PathRobot robot = path_robot({{0.0, {0.0, 0.0, 0.0}}, {1.0, {1.0, 0.0, 0.0}}});
  step_for(robot, 20);
  Eigen::Isometry3d T_map_base = to_isometry({0.2, 5.0, 0.0});
  T_map_base.translation().z() = 0.4;
  for (int i = 0; i < 30; ++i) robot.step_held(T_map_base, HeldWheels::kDriven);
  EXPECT_TRUE(robot.state().T_map_base.isApprox(T_map_base));
  expect_wheels(robot.state(), 0.2, 0.2);
  robot.step();
  expect_pose(planar_pose(robot), {0.51, 0.0, 0.0}, 1e-9);
  EXPECT_EQ(robot.state().T_map_base.translation().z(), 0.0);
}

TEST(PathRobot, IsPutElsewhereUntilItsNextStep) {
  PathRobot robot = path_robot(kCorner);
  robot.teleport({-4.0, 1.0, 0.2});
  expect_pose(planar_pose(robot), {-4.0, 1.0, 0.2});
  expect_wheels(robot.state(), 0.0, 0.0);
  robot.step();
  expect_pose(planar_pose(robot), {1.01, 2.0, 0.0}, 1e-9);
}

// Odometry of ideal wheels follows a path that a differential drive can make.
TEST(PathRobot, IsWhereItsWheelsTookIt) {
  std::vector<TimedPose> path = {{0.0, {0.5, -1.0, 0.3}}};
  for (int i = 1; i <= 500; ++i) {
    path.push_back({0.01 * i, path.back().T_map_base * arc(0.005, 0.01 * std::sin(0.02 * i))});
  }
  PathRobot robot = path_robot(path);
  Pose2 T_map_base = path.front().T_map_base;
  WheelAngles before = robot.state().wheels;
  for (int i = 1; i <= 500; ++i) {
    robot.step();
    const double left = kPathRadius * (robot.state().wheels.left - before.left);
    const double right = kPathRadius * (robot.state().wheels.right - before.right);
    T_map_base = T_map_base * arc(0.5 * (left + right), (right - left) / kPathTrack);
    before = robot.state().wheels;
  }
  expect_pose(T_map_base, planar_pose(robot), 1e-4);
}

}  // namespace
}  // namespace castaway::sim
