/// A robot that follows recorded poses.
#pragma once

#include <chrono>
#include <cstdint>
#include <vector>

#include "sim/common/geometry.hpp"
#include "sim/events/lift.hpp"
#include "sim/robot/bodies/robot_state.hpp"
#include "sim/robot/urdf/robot_model.hpp"

namespace castaway::sim {

/// A pose of base in map and its time.
struct TimedPose {
  double t_s = 0.0;  ///< [s] Since the start of the run.
  Pose2 T_map_base;
};

/// The pose at a time: linear between two poses, with the shorter turn; the first one before the
/// path and the last one after it. `path` is ordered by time and not empty.
Pose2 pose_at(const std::vector<TimedPose>& path, double t_s);

/// Moves along a path whatever is in the way. Wheels turn as the motion along and about base
/// demands; motion across it, which no differential drive makes, does not turn them.
class PathRobot {
 public:
  /// `path`: not empty; `time_step`: above 0.
  PathRobot(const RobotModel& robot, std::vector<TimedPose> path,
            std::chrono::nanoseconds time_step);

  /// Commands have no effect.
  void set_command(const Twist2&) {}
  void step();
  /// As in `RobotPhysics`; the path goes on from its own pose at that time afterwards.
  void step_held(const Eigen::Isometry3d& T_map_base, HeldWheels wheels);
  void teleport(const Pose2& T_map_base);
  [[nodiscard]] const RobotState& state() const { return state_; }
  [[nodiscard]] std::int64_t collisions() const { return 0; }
  [[nodiscard]] bool touching() const { return false; }

 private:
  double track_;
  double wheel_radius_;
  Eigen::Vector2d p_base_axle_;
  std::vector<TimedPose> path_;
  std::chrono::nanoseconds time_step_;
  std::chrono::nanoseconds now_{};
  Pose2 T_map_base_;
  RobotState state_;
};

}  // namespace castaway::sim
