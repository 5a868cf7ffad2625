/// Drives a route by a pose that is believed and by what the lidar sees.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/common/geometry.hpp"
#include "sim/map/grid.hpp"
#include "sim/navigation/dynamic_window.hpp"
#include "sim/navigation/live_scan.hpp"
#include "sim/navigation/movers.hpp"
#include "sim/navigation/passing.hpp"
#include "sim/navigation/recoveries.hpp"
#include "sim/navigation/route_runner.hpp"

namespace castaway::sim {

/// What a navigator needs to know.
struct NavigatorConfig {
  RouteConfig route;
  DynamicWindowConfig local;
  RecoveryTimes recoveries;
  double plan_margin = 0.04;  ///< [m] Room that plans keep around the footprint.
  double period = 0.05;       ///< [s] Between two commands.
};

/// A global plan on the map, the dynamic window towards it around what is there, recoveries where
/// that does not get on, and an emergency stop below all of them. It knows the map, the believed
/// pose, odometry and scans; not the truth.
class Navigator {
 public:
  /// `map`: what the robot knows of the world.
  Navigator(const NavigatorConfig& config, const Grid& map);

  void on_odometry(const OdometryReading& reading) { live_.on_odometry(reading); }
  void on_scan(const LidarReading& scan, const LidarConfig& lidar) { live_.on_scan(scan, lidar); }
  /// The velocity to command, believed to be at `T_map_base`; zero without a pose.
  Twist2 command(const std::optional<Pose2>& T_map_base);
  /// True at the end of the route, and without one.
  [[nodiscard]] bool done() const { return route_.done(); }
  /// Waypoints that were reached so far.
  [[nodiscard]] int passed() const { return route_.passed(); }
  /// Recoveries begun and "emergency stop"s since the last call.
  [[nodiscard]] std::vector<std::string> take_events();

 private:
  Twist2 drive(const Pose2& T_map_base, const std::vector<Eigen::Vector2d>& p_base);
  void replan(const Pose2& T_map_base, const std::vector<Eigen::Vector2d>& p_base);
  void watch_movers(const Pose2& T_map_base);
  [[nodiscard]] Eigen::Vector2d velocity_at(const Eigen::Vector2d& p_base,
                                            const Pose2& T_map_base) const;
  Twist2 stopped_short(const Twist2& twist, const Pose2& T_map_base,
                       const std::vector<Eigen::Vector2d>& p_base);

  NavigatorConfig config_;
  Grid map_;
  FreeSpace mapped_;  ///< Tells what the map has from what it has not.
  RouteRunner route_;
  LiveScan live_;
  Movers movers_;
  std::vector<Mover> seen_;    ///< In base.
  std::vector<Mover> moving_;  ///< Those of them who move.
  Passing passing_;
  Recoveries recoveries_;
  double stop_left_ = 0.0;  ///< [s] Of an emergency stop, once begun seen through to standing.
  std::vector<std::string> events_;
};

}  // namespace castaway::sim
