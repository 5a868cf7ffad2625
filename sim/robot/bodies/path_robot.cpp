#include "sim/robot/bodies/path_robot.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

#include "sim/common/seconds.hpp"

namespace castaway::sim {

Pose2 pose_at(const std::vector<TimedPose>& path, double t_s) {
  assert(!path.empty());
  const auto after = std::upper_bound(path.begin(), path.end(), t_s,
                                      [](double t, const TimedPose& pose) { return t < pose.t_s; });
  if (after == path.begin()) return path.front().T_map_base;
  if (after == path.end()) return path.back().T_map_base;
  const Pose2& a = (after - 1)->T_map_base;
  const Pose2& b = after->T_map_base;
  const double part = (t_s - (after - 1)->t_s) / (after->t_s - (after - 1)->t_s);
  return {a.x + part * (b.x - a.x), a.y + part * (b.y - a.y),
          wrap_angle(a.yaw + part * wrap_angle(b.yaw - a.yaw))};
}

PathRobot::PathRobot(const RobotModel& robot, std::vector<TimedPose> path,
                     std::chrono::nanoseconds time_step)
    : track_(robot.track),
      wheel_radius_(robot.wheel_radius),
      p_base_axle_(robot.p_base_axle),
      path_(std::move(path)),
      time_step_(time_step) {
  teleport(pose_at(path_, 0.0));
}

void PathRobot::step() {
  now_ += time_step_;
  const Pose2 T_base_axle{p_base_axle_.x(), p_base_axle_.y(), 0.0};
  const Pose2 to = pose_at(path_, to_seconds(now_));
  const Pose2 u = inverse(T_map_base_ * T_base_axle) * to * T_base_axle;
  state_.wheels.left += (u.x - 0.5 * track_ * u.yaw) / wheel_radius_;
  state_.wheels.right += (u.x + 0.5 * track_ * u.yaw) / wheel_radius_;
  teleport(to);
}

void PathRobot::step_held(const Eigen::Isometry3d& T_map_base, HeldWheels) {
  now_ += time_step_;
  T_map_base_ = to_planar(T_map_base);
  state_.T_map_base = T_map_base;
}

void PathRobot::teleport(const Pose2& T_map_base) {
  T_map_base_ = T_map_base;
  state_.T_map_base = to_isometry(T_map_base);
}

}  // namespace castaway::sim
