#include "sim/robot/skid_steer.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <fmt/format.h>

#include "sim/robot/robot_physics.hpp"

namespace castaway::sim {
namespace {

constexpr std::chrono::nanoseconds kStep = std::chrono::milliseconds(2);
constexpr int kSettleSteps = 1000;
constexpr int kTurnSteps = 1000;
constexpr double kTurnRate = 0.5;       // [rad/s]
constexpr double kFloor = 20.0;         // [m]
constexpr double kGravity = 9.81;       // [m/s^2]
constexpr double kReserve = 1.2;        // Of torque over friction.
constexpr double kLargestRatio = 10.0;  // Of measured to geometric; beyond it does not turn.

WorldSpec bare_floor() {
  WorldSpec world;
  world.min_corner = Eigen::Vector2d::Constant(-0.5 * kFloor);
  world.max_corner = Eigen::Vector2d::Constant(0.5 * kFloor);
  return world;
}

double yaw_of(const RobotState& state) { return to_planar(state.T_map_base).yaw; }

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

void strengthen_motors(RobotModel& robot) {
  double mass = robot.chassis_mass;
  for (const DriveWheel& wheel : robot.wheels) mass += wheel.mass;
  const double load = kGravity * mass / static_cast<double>(robot.wheels.size());
  double lowest = 0.0;
  for (DriveWheel& wheel : robot.wheels) {
    if (wheel.effort_max <= 0.0 || wheel.effort_max > kReserve * load * wheel.radius) continue;
    lowest = lowest > 0.0 ? std::min(lowest, wheel.effort_max) : wheel.effort_max;
    wheel.effort_max = 0.0;
  }
  if (lowest <= 0.0) return;
  robot.warnings.push_back(
      fmt::format("with <limit effort=\"{}\"> the wheels cannot skid, and the robot not turn: the "
                  "limit is lifted",
                  lowest));
}

double measured_skid_track(const RobotModel& robot) {
  RobotPhysics physics(bare_floor(), robot, {}, {1.0, kTurnRate, 1.0, 1.0}, kStep);
  physics.set_command({0.0, kTurnRate});
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
  return sound ? track : robot.track;
}

}  // namespace castaway::sim
