/// What drives the robot in a simulated run.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "sim/common/geometry.hpp"
#include "sim/navigation/navigator.hpp"
#include "sim/navigation/route_runner.hpp"
#include "sim/sensor/readings.hpp"
#include "sim/stages/people_stage.hpp"
#include "sim/stages/simulation_config.hpp"

namespace castaway::sim {

/// Turns poses, odometry and scans into velocity commands, one a control period: a recorded log of
/// them, a route by the truth, or a route by what a localizer believes.
class DriveStage {
 public:
  /// `drive_grid`: where the robot's body can be.
  DriveStage(const SimulationConfig& config, const Grid& drive_grid);

  /// True where a command is due at `now`.
  [[nodiscard]] bool due(std::chrono::nanoseconds now) const { return now >= next_; }
  /// The command at `now` for a robot that truly is at `T_map_base`; people may make it yield.
  Twist2 command(std::chrono::nanoseconds now, const Pose2& T_map_base, PeopleStage& people);
  /// What the driving localizer believes; nothing: it has no answer.
  void set_pose(const std::optional<Pose2>& T_map_base) { believed_ = T_map_base; }
  /// What the robot's sensors delivered.
  void on_odometry(const OdometryReading& reading);
  void on_scan(const LidarReading& scan, const LidarConfig& lidar);
  /// True if the last command was to get the robot on: there is a route or a log to drive, nobody
  /// is in the way, and what the robot believes about its pose is right.
  [[nodiscard]] bool wants() const { return wants_; }
  /// Waypoints that were reached so far.
  [[nodiscard]] int passed() const { return navigator_ ? navigator_->passed() : route_->passed(); }
  /// Recoveries and emergency stops since the last call.
  [[nodiscard]] std::vector<std::string> take_events();

 private:
  [[nodiscard]] bool believes_rightly(const Pose2& T_map_base) const;
  [[nodiscard]] bool somebody_near(const Pose2& T_map_base, const PeopleStage& people) const;

  std::chrono::nanoseconds wait_;
  std::vector<TimedTwist> log_;
  std::optional<RouteRunner> route_;    ///< By the truth.
  std::optional<Navigator> navigator_;  ///< By the estimate.
  std::optional<Pose2> believed_;
  double radius_;  ///< [m] Of the robot.
  bool wants_ = false;
  std::chrono::nanoseconds next_{};
};

}  // namespace castaway::sim
