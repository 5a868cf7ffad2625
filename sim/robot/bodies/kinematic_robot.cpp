#include "sim/robot/bodies/kinematic_robot.hpp"

#include <cmath>
#include <utility>

#include "sim/common/seconds.hpp"

namespace castaway::sim {
namespace {

constexpr double kContactGap = 0.5;  // [s] Contacts closer in time are one collision.

}  // namespace

KinematicRobot::KinematicRobot(const RobotModel& robot, FreeSpace free, const Pose2& start,
                               const TwistLimits& limits, std::chrono::nanoseconds time_step)
    : track_(robot.track),
      wheel_radius_(robot.wheel_radius),
      p_base_axle_(robot.p_base_axle),
      free_(std::move(free)),
      limits_(limits),
      time_step_(to_seconds(time_step)),
      contact_age_(kContactGap) {
  teleport(start);
}

void KinematicRobot::turn_wheels() {
  const double step = time_step_ / wheel_radius_;
  const Twist2 axle = axle_twist(twist_, p_base_axle_);
  state_.wheels.left += (axle.v - 0.5 * track_ * axle.w) * step;
  state_.wheels.right += (axle.v + 0.5 * track_ * axle.w) * step;
}

/// A robot closer to an obstacle than its radius may leave it, but not come closer.
bool KinematicRobot::is_blocked(const Pose2& from, const Pose2& to) const {
  if (free_.contains(to.position())) return false;
  if (free_.contains(from.position())) return true;
  return free_.clearance_at(to.position()) < free_.clearance_at(from.position());
}

void KinematicRobot::step() {
  twist_ = ramp_twist(twist_, command_, limits_, time_step_);
  const Pose2 T_base_axle{p_base_axle_.x(), p_base_axle_.y(), 0.0};
  const Twist2 axle = axle_twist(twist_, p_base_axle_);
  const Pose2 to = T_map_base_ * T_base_axle * arc(axle.v * time_step_, axle.w * time_step_) *
                   inverse(T_base_axle);
  const bool touches = twist_.v != 0.0 && is_blocked(T_map_base_, to);
  if (touches) {
    if (contact_age_ >= kContactGap) ++collisions_;
    twist_ = {};
  } else {
    turn_wheels();
    T_map_base_ = to;
    state_.T_map_base = to_isometry(to);
  }
  contact_age_ = touches ? 0.0 : contact_age_ + time_step_;
}

void KinematicRobot::step_held(const Eigen::Isometry3d& T_map_base, HeldWheels wheels) {
  twist_ =
      held_twist(wheels, twist_, ramp_twist(twist_, command_, limits_, time_step_), time_step_);
  turn_wheels();
  T_map_base_ = to_planar(T_map_base);
  state_.T_map_base = T_map_base;
}

void KinematicRobot::teleport(const Pose2& T_map_base) {
  twist_ = {};
  T_map_base_ = T_map_base;
  state_.T_map_base = to_isometry(T_map_base);
}

}  // namespace castaway::sim
