/// Drives a route of waypoints from wherever the robot is.
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "sim/common/geometry.hpp"
#include "sim/map/free_space.hpp"
#include "sim/navigation/path_follower.hpp"

namespace castaway::sim {

/// A route and how it is driven.
struct RouteConfig {
  std::vector<Eigen::Vector2d> waypoints;  ///< [m] In map; if empty, the robot stands still.
  bool loop = true;                        ///< Starts again after the last waypoint.
  /// [m] Re-plans when the robot is farther than this from its path.
  double replan_distance = 0.4;
  FollowerConfig follower;
};

/// The next stretch of the path, in map. [m]
struct Lane {
  Eigen::Vector2d from = Eigen::Vector2d::Zero();  ///< Point of the path nearest to the robot.
  Eigen::Vector2d to = Eigen::Vector2d::Zero();    ///< Point that the robot aims at.
};

/// Plans from waypoint to waypoint. If a waypoint is not free, the nearest free cell stands in for
/// it. A waypoint within tolerance is finished. Re-plans after a jump of the pose.
class RouteRunner {
 public:
  /// `free`: where the robot's centre can be.
  RouteRunner(RouteConfig config, FreeSpace free);

  /// Returns the velocity to command at a pose; zero without a pose and at the end of the route.
  Twist2 command(const std::optional<Pose2>& T_map_base);
  /// True at the end of the route, and if there is no route.
  [[nodiscard]] bool done() const { return waypoint_ >= config_.waypoints.size(); }
  /// Waypoints reached so far; one is not counted if its nearest free place is more than 0.2 m
  /// away.
  [[nodiscard]] int waypoints_reached() const { return passed_; }
  /// Re-plans to the next waypoint in `free`, which excludes obstacles in the way. Keeps the
  /// current path if there is none.
  void detour(const Pose2& T_map_base, FreeSpace free);
  /// Plans anew in another free space: the world changed, or the robot is in another part of it.
  void set_free(FreeSpace free);
  /// The lane up to the point that the last command aimed at; nothing without a path.
  [[nodiscard]] std::optional<Lane> lane() const {
    if (!follower_ || !follower_->aim()) return std::nullopt;
    return Lane{follower_->nearest(), *follower_->aim()};
  }
  /// The current path; empty if there is none.
  [[nodiscard]] std::vector<Eigen::Vector2d> path() const;
  /// Free space to plan in when nothing is in the way.
  [[nodiscard]] const FreeSpace& free() const { return free_; }

 private:
  void plan(const Pose2& T_map_base);
  void next_waypoint();

  RouteConfig config_;
  FreeSpace free_;
  std::optional<FreeSpace> detour_;  ///< Used until the next waypoint.
  std::size_t waypoint_ = 0;
  int passed_ = 0;
  std::optional<PathFollower> follower_;
};

}  // namespace castaway::sim
