/// Follows a path by pure pursuit with turns in place.
///
/// R. C. Coulter, "Implementation of the Pure Pursuit Path Tracking Algorithm", CMU-RI-TR-92-01,
/// 1992. We add: the line to the target stays in free space, so that corners are not cut; the robot
/// turns in place while its heading error is large; it slows down in curves and before the end.
/// errors of heading are turned away on the spot; the robot slows down for curves and the end.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "sim/common/geometry.hpp"
#include "sim/map/free_space.hpp"
#include "sim/robot/bodies/twist_ramp.hpp"

namespace castaway::sim {

/// Parameters of path following.
struct FollowerConfig {
  TwistLimits limits;
  double lookahead = 0.5;       ///< [m]
  double turn_above = 0.8;      ///< [rad] A larger heading error starts a turn in place.
  double turn_until = 0.15;     ///< [rad] A smaller one ends it.
  double goal_tolerance = 0.1;  ///< [m]
};

/// Follows one path.
class PathFollower {
 public:
  PathFollower(const FollowerConfig& config, std::vector<Eigen::Vector2d> path);

  /// Returns the velocity to command at a pose; zero at the goal.
  Twist2 command(const Pose2& T_map_base, const FreeSpace& free);
  /// True once the end of the path is within tolerance.
  [[nodiscard]] bool has_arrived(const Pose2& T_map_base) const;
  /// Distance from the nearest point of the path. [m]
  [[nodiscard]] double off_path(const Pose2& T_map_base) const;
  /// Point in map that the last command aimed at; none before the first.
  [[nodiscard]] const std::optional<Eigen::Vector2d>& aim() const { return aim_; }
  /// Point of the path nearest to the robot.
  [[nodiscard]] const Eigen::Vector2d& nearest() const { return path_[nearest_]; }
  [[nodiscard]] const std::vector<Eigen::Vector2d>& path() const { return path_; }

 private:
  void advance(const Eigen::Vector2d& p_map);
  [[nodiscard]] Eigen::Vector2d target(const Eigen::Vector2d& p_map, const FreeSpace& free) const;

  FollowerConfig config_;
  std::vector<Eigen::Vector2d> path_;
  std::vector<double> way_to_end_;  ///< [m] Along the path, from each point.
  std::size_t nearest_ = 0;  ///< Index of the path's point nearest to the robot; never decreases.
  bool turning_ = false;
  std::optional<Eigen::Vector2d> aim_;
};

}  // namespace castaway::sim
