/// Drives the robot in a simulated run.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/common/geometry.hpp"
#include "sim/navigation/navigator.hpp"
#include "sim/navigation/route_runner.hpp"
#include "sim/sensor/readings.hpp"
#include "sim/stages/people_stage.hpp"
#include "sim/stages/simulation_config.hpp"

namespace castaway::sim {

/// Turns poses, odometry and scans into velocity commands, one per control period: from a recorded
/// log, along a route by the true pose, or along a route by a localizer's estimate.
class DriveStage {
 public:
  DriveStage(const SimulationConfig& config, Spaces& spaces);

  /// True if a command is due at `now`.
  [[nodiscard]] bool due(std::chrono::nanoseconds now) const { return now >= next_; }
  /// Returns the command at `now` for a robot whose true pose is `T_map_base`; it may give way to
  /// people.
  Twist2 command(std::chrono::nanoseconds now, const Pose2& T_map_base, PeopleStage& people);
  /// Sets the driving localizer's estimate; nothing if it has none.
  void set_pose(const std::optional<Pose2>& T_map_base) { estimate_ = T_map_base; }
  /// Drives by this velocity; nothing: as configured.
  void set_command(const std::optional<Twist2>& command) { command_ = command; }
  /// Plans in another free space of `kDriveMargin` more than the robot's radius. A robot that
  /// drives by its estimate knows the map only, and what its lidar sees.
  void set_free(FreeSpace free) {
    if (route_) route_->set_free(std::move(free));
  }
  /// Take what the robot's sensors delivered.
  void on_odometry(const OdometryReading& reading);
  void on_scan(const LidarReading& scan, const LidarConfig& lidar);
  /// True if the last command was meant to move the robot: there is a route or a log to drive, no
  /// person is in the way, and the estimated pose is right.
  [[nodiscard]] bool wants() const { return wants_; }
  /// Waypoints reached so far.
  [[nodiscard]] int waypoints_reached() const {
    return navigator_ ? navigator_->waypoints_reached() : route_->waypoints_reached();
  }
  /// Recoveries and emergency stops since the last call.
  [[nodiscard]] std::vector<Driving> take_events();

 private:
  [[nodiscard]] bool is_estimate_right(const Pose2& T_map_base) const;
  [[nodiscard]] bool is_person_near(const Pose2& T_map_base, const PeopleStage& people) const;

  std::chrono::nanoseconds wait_;
  std::vector<TimedTwist> log_;
  std::optional<RouteRunner> route_;    ///< Drives by the true pose.
  std::optional<Navigator> navigator_;  ///< Drives by the estimate.
  std::optional<Pose2> estimate_;
  std::optional<Twist2> command_;
  double radius_;  ///< [m] Of the robot.
  bool wants_ = false;
  std::chrono::nanoseconds next_{};
};

}  // namespace castaway::sim
