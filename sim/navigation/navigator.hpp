/// Drives a route by the estimated pose and the lidars' scans.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/common/geometry.hpp"
#include "sim/map/grid.hpp"
#include "sim/navigation/dynamic_window.hpp"
#include "sim/navigation/emergency_stop.hpp"
#include "sim/navigation/live_scan.hpp"
#include "sim/navigation/mover_watch.hpp"
#include "sim/navigation/passing.hpp"
#include "sim/navigation/recoveries.hpp"
#include "sim/navigation/route_runner.hpp"

namespace castaway::sim {

/// Parameters of a navigator.
struct NavigatorConfig {
  RouteConfig route;
  DynamicWindowConfig local;
  RecoveryTimes recoveries;
  double plan_margin = 0.04;  ///< [m] Room that planned paths keep around the footprint.
  double period = 0.05;       ///< [s] Between two commands.
};

/// Plans globally on the map, follows the plan with the dynamic window around obstacles that the
/// lidars see, recovers where the robot makes no progress, and stops it in an emergency. Uses the
/// map, the estimated pose, odometry and scans; no ground truth.
class Navigator {
 public:
  /// `map`: known to the robot; may differ from the world.
  Navigator(const NavigatorConfig& config, const Grid& map);

  void on_odometry(const OdometryReading& reading) { live_.on_odometry(reading); }
  void on_scan(const LidarReading& scan, const LidarConfig& lidar) { live_.on_scan(scan, lidar); }
  /// Returns the velocity to command at the estimated pose `T_map_base`; zero without a pose.
  Twist2 command(const std::optional<Pose2>& T_map_base);
  /// True at the end of the route, and if there is no route.
  [[nodiscard]] bool done() const { return route_.done(); }
  /// Waypoints reached so far.
  [[nodiscard]] int waypoints_reached() const { return route_.waypoints_reached(); }
  /// Names of the recoveries begun, and "emergency stop"s, since the last call.
  [[nodiscard]] std::vector<Driving> take_events();

 private:
  Twist2 drive(const Pose2& T_map_base, const std::vector<Eigen::Vector2d>& p_base);

  NavigatorConfig config_;
  Grid map_;
  RouteRunner route_;
  LiveScan live_;
  MoverWatch watch_;
  Passing passing_;
  Recoveries recoveries_;
  EmergencyStop stop_;
  std::vector<Driving> events_;
};

}  // namespace castaway::sim
