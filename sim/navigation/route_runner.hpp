/// Drives a route of waypoints, wherever the robot finds itself.
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "sim/common/geometry.hpp"
#include "sim/map/free_space.hpp"
#include "sim/navigation/path_follower.hpp"

namespace castaway::sim {

/// A route.
struct RouteConfig {
  std::vector<Eigen::Vector2d> waypoints;  ///< [m] In map; none: stand still.
  bool loop = true;                        ///< Starts again after the last.
  double replan_distance = 0.4;            ///< [m] Further off the path, the robot plans anew.
  FollowerConfig follower;
};

/// The stretch of path just ahead, in map. [m]
struct Lane {
  Eigen::Vector2d from = Eigen::Vector2d::Zero();  ///< What the robot has come to.
  Eigen::Vector2d to = Eigen::Vector2d::Zero();    ///< What it aims at.
};

/// Plans from waypoint to waypoint. A waypoint that is not free stands for the nearest free place;
/// one within tolerance is done with. After a jump of the pose it plans anew.
class RouteRunner {
 public:
  /// `free`: where the robot's centre can be.
  RouteRunner(RouteConfig config, FreeSpace free);

  /// The velocity to command at a pose; zero without one and at the end of the route.
  Twist2 command(const std::optional<Pose2>& T_map_base);
  /// True at the end of the route, and without one.
  [[nodiscard]] bool done() const { return waypoint_ >= config_.waypoints.size(); }
  /// Waypoints that were reached so far; a free place more than 0.2 m beside is not counted.
  [[nodiscard]] int passed() const { return passed_; }
  /// Drives to the next waypoint through `free` instead, which leaves out what is in the way. Stays
  /// with its path where there is none.
  void detour(const Pose2& T_map_base, FreeSpace free);
  /// Up to the point that the last command aimed at; nothing without a path.
  [[nodiscard]] std::optional<Lane> lane() const {
    if (!follower_ || !follower_->aim()) return std::nullopt;
    return Lane{follower_->nearest(), *follower_->aim()};
  }
  /// The path being driven; empty if none.
  [[nodiscard]] std::vector<Eigen::Vector2d> path() const;
  /// Where it plans when nothing is in the way.
  [[nodiscard]] const FreeSpace& free() const { return free_; }

 private:
  void plan(const Pose2& T_map_base);
  void next_waypoint();

  RouteConfig config_;
  FreeSpace free_;
  std::optional<FreeSpace> detour_;  ///< Holds until the next waypoint.
  std::size_t waypoint_ = 0;
  int passed_ = 0;
  std::optional<PathFollower> follower_;
};

}  // namespace castaway::sim
