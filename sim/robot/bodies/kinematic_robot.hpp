/// A robot without physics: it moves exactly as commanded.
#pragma once

#include <chrono>
#include <cstdint>
#include <utility>

#include "sim/common/geometry.hpp"
#include "sim/events/lift.hpp"
#include "sim/map/free_space.hpp"
#include "sim/robot/bodies/robot_state.hpp"
#include "sim/robot/bodies/twist_ramp.hpp"
#include "sim/robot/urdf/robot_model.hpp"

namespace castaway::sim {

/// Integrates the unicycle model exactly: arcs of constant velocity within a step. The floor is
/// flat and wheels do not slip. A step that would bring the robot's disc into an obstacle of the
/// grid is not made, and the robot stops. For speed, and for robot descriptions whose contacts
/// physics cannot handle.
class KinematicRobot {
 public:
  /// `free`: where the centre of the robot's disc can be. `time_step`: above 0.
  KinematicRobot(const RobotModel& robot, FreeSpace free, const Pose2& start,
                 const TwistLimits& limits, std::chrono::nanoseconds time_step);

  /// From now on, the centre of its disc can be here.
  void set_free(FreeSpace free) { free_ = std::move(free); }
  /// As in `RobotPhysics`.
  void set_command(const Twist2& command) { command_ = command; }
  void step();
  void step_held(const Eigen::Isometry3d& T_map_base, HeldWheels wheels);
  void teleport(const Pose2& T_map_base);
  [[nodiscard]] const RobotState& state() const { return state_; }
  /// Number of times the robot ran into an obstacle.
  [[nodiscard]] std::int64_t collisions() const { return collisions_; }
  /// True while an obstacle blocks the robot.
  [[nodiscard]] bool touching() const { return contact_age_ == 0.0; }

 private:
  void turn_wheels();
  [[nodiscard]] bool is_blocked(const Pose2& from, const Pose2& to) const;

  double track_;
  double wheel_radius_;
  Eigen::Vector2d p_base_axle_;
  FreeSpace free_;
  TwistLimits limits_;
  double time_step_;
  Twist2 command_;
  Twist2 twist_;
  Pose2 T_map_base_;
  RobotState state_;
  std::int64_t collisions_ = 0;
  double contact_age_;
};

}  // namespace castaway::sim
