#include "sim/robot/bodies/skid_steer.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <fmt/format.h>

#include "sim/robot/bodies/robot_masses.hpp"
#include "sim/robot/bodies/robot_physics.hpp"

namespace castaway::sim {
namespace {

constexpr std::chrono::nanoseconds kTrialStep = std::chrono::milliseconds(2);
constexpr int kSettleSteps = 1000;
constexpr int kTurnSteps = 1000;
constexpr double kTrialTurnRate = 0.5;  // [rad/s]
constexpr double kTrialFloor = 20.0;    // [m]
constexpr double kReserve = 1.2;        // Factor of the torque over friction.
constexpr double kLeastOffset = 0.01;   // [m] A smaller offset is not corrected.
// Largest ratio of measured and ideal track; above it the robot does not turn.
constexpr double kLargestRatio = 10.0;

WorldSpec bare_floor() {
  WorldSpec world;
  world.min_corner = Eigen::Vector2d::Constant(-0.5 * kTrialFloor);
  world.max_corner = Eigen::Vector2d::Constant(0.5 * kTrialFloor);
  return world;
}

double yaw_of(const RobotState& state) { return to_planar(state.T_map_base).yaw; }

/// The point of base that does not move between two poses with different headings. [m]
Eigen::Vector2d pivot(const Pose2& T_map_a, const Pose2& T_map_b) {
  const Eigen::Matrix2d turned = Eigen::Rotation2Dd(T_map_a.yaw).toRotationMatrix() -
                                 Eigen::Rotation2Dd(T_map_b.yaw).toRotationMatrix();
  return turned.inverse() * (T_map_b.position() - T_map_a.position());
}

}  // namespace

double ideal_skid_track(const RobotModel& robot) {
  double front = robot.wheels.front().p_base_wheel.x();
  double back = front;
  for (const DriveWheel& wheel : robot.wheels) {
    front = std::max(front, wheel.p_base_wheel.x());
    back = std::min(back, wheel.p_base_wheel.x());
  }
  const double separation = robot.wheel_separation;
  return separation + (front - back) * (front - back) / separation;
}

void remove_low_effort_limits(RobotModel& robot) {
  const double load = wheel_load(robot);
  double lowest = 0.0;
  for (DriveWheel& wheel : robot.wheels) {
    if (wheel.effort_max <= 0.0 || wheel.effort_max > kReserve * load * wheel.radius) continue;
    lowest = lowest > 0.0 ? std::min(lowest, wheel.effort_max) : wheel.effort_max;
    wheel.effort_max = 0.0;
  }
  if (lowest <= 0.0) return;
  robot.warnings.push_back(
      fmt::format("the wheels cannot skid with <limit effort=\"{}\">, so the robot could not turn: "
                  "the limit is ignored",
                  lowest));
}

SkidTurn measure_skid_turn(const RobotModel& robot) {
  RobotPhysics physics(bare_floor(), robot, {}, {1.0, kTrialTurnRate, 1.0, 1.0}, kTrialStep);
  physics.set_command({0.0, kTrialTurnRate});
  for (int i = 0; i < kSettleSteps; ++i) physics.step();
  const RobotState before = physics.state();
  for (int i = 0; i < kTurnSteps; ++i) physics.step();
  const RobotState& after = physics.state();
  const double turned = wrap_angle(yaw_of(after) - yaw_of(before));
  const double rolled =
      (after.wheels.right - before.wheels.right) - (after.wheels.left - before.wheels.left);
  const double track = rolled * robot.wheel_radius / turned;
  const bool sound = std::isfinite(track) && track > 0.5 * robot.wheel_separation &&
                     track < kLargestRatio * robot.wheel_separation;
  if (!sound) return {robot.track, robot.p_base_axle.y()};
  const double y = pivot(to_planar(before.T_map_base), to_planar(after.T_map_base)).y();
  const double aside = std::abs(y - robot.p_base_axle.y());
  const bool matters = aside > kLeastOffset && aside < 0.5 * robot.wheel_separation;
  return {track, matters ? y : robot.p_base_axle.y()};
}

void steer_by_skidding(RobotModel& robot) {
  remove_low_effort_limits(robot);
  robot.track = ideal_skid_track(robot);
  const SkidTurn turn = measure_skid_turn(robot);
  robot.track = turn.track;
  robot.p_base_axle.y() = turn.axle_y;
}

}  // namespace castaway::sim
