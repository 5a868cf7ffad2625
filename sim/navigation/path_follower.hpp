/// Drives along a path: pure pursuit with turns on the spot.
///
/// R. C. Coulter, "Implementation of the Pure Pursuit Path Tracking Algorithm", CMU-RI-TR-92-01,
/// 1992. We add: the target stays in sight within free space, so that corners are not cut; large
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

/// How a path is followed.
struct FollowerConfig {
  TwistLimits limits;
  double lookahead = 0.5;       ///< [m]
  double turn_above = 0.8;      ///< [rad] Larger errors of heading are turned away standing.
  double turn_until = 0.15;     ///< [rad] Such a turn ends below.
  double goal_tolerance = 0.1;  ///< [m]
};

/// Follows one path.
class PathFollower {
 public:
  PathFollower(const FollowerConfig& config, std::vector<Eigen::Vector2d> path);

  /// The velocity to command at a pose. Zero at the goal.
  Twist2 command(const Pose2& T_map_base, const FreeSpace& free);
  /// True once the end of the path is within tolerance.
  [[nodiscard]] bool arrived(const Pose2& T_map_base) const;
  /// Distance from the part of the path being followed. [m]
  [[nodiscard]] double off_path(const Pose2& T_map_base) const;
  /// The point of map that the last command aimed at; none before the first.
  [[nodiscard]] const std::optional<Eigen::Vector2d>& aim() const { return aim_; }
  /// The point of the path that the robot has come to.
  [[nodiscard]] const Eigen::Vector2d& nearest() const { return path_[nearest_]; }
  [[nodiscard]] const std::vector<Eigen::Vector2d>& path() const { return path_; }

 private:
  void advance(const Eigen::Vector2d& p_map);
  [[nodiscard]] Eigen::Vector2d target(const Eigen::Vector2d& p_map, const FreeSpace& free) const;

  FollowerConfig config_;
  std::vector<Eigen::Vector2d> path_;
  std::vector<double> way_to_end_;  ///< [m] From each point of the path.
  std::size_t nearest_ = 0;         ///< Point of the path nearest to the robot; only moves on.
  bool turning_ = false;
  std::optional<Eigen::Vector2d> aim_;
};

}  // namespace castaway::sim
