/// What drives the robot in a simulated run.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "sim/geometry.hpp"
#include "sim/navigation/navigator.hpp"
#include "sim/navigation/route_runner.hpp"
#include "sim/people_stage.hpp"
#include "sim/sensor/readings.hpp"
#include "sim/simulation.hpp"

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
  /// Recoveries and emergency stops since the last call.
  [[nodiscard]] std::vector<std::string> take_events();

 private:
  std::chrono::nanoseconds wait_;
  std::vector<TimedTwist> log_;
  std::optional<RouteRunner> route_;    ///< By the truth.
  std::optional<Navigator> navigator_;  ///< By the estimate.
  std::optional<Pose2> believed_;
  std::chrono::nanoseconds next_{};
};

}  // namespace castaway::sim
