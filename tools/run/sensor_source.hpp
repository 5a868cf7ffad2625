/// The seam between a run and where its sensor data come from: the simulator or a recorded log.
#pragma once

#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tools/run/frame.hpp"

namespace castaway::testbed {

/// A stream of frames.
class SensorSource {
 public:
  virtual ~SensorSource() = default;

  /// The next frame, `nullopt` at the end.
  virtual std::optional<Frame> next() = 0;
  /// Sets the estimate of the driving localizer. Ignored unless the robot drives by it.
  virtual void set_drive_pose(const std::optional<SE2>& T_map_base) = 0;
  /// Sets the estimate of the watched localizer and its height [m]; nothing while it has none or is
  /// lost. Ignored by sources without triggered kidnaps.
  virtual void set_watched_pose(const std::optional<SE2>& T_map_base, double z) = 0;
  /// Drives the robot from now on, in place of its route. Ignored by sources whose robot cannot be
  /// driven.
  virtual void set_velocity(const BaseVelocity&) {}
  /// True pose of base at the start; `nullopt` if it is unknown.
  [[nodiscard]] virtual std::optional<SE2> start_pose() const = 0;
  /// Total simulated or recorded time, for progress. Zero if unknown.
  [[nodiscard]] virtual Stamp duration() const = 0;
  /// CPU time spent so far by stage ("physics", "lidar", "people"); empty where not measured.
  [[nodiscard]] virtual std::map<std::string, std::chrono::nanoseconds> cpu_by_stage() const = 0;
  /// Deviations from the request so far, one sentence each.
  [[nodiscard]] virtual std::vector<std::string> warnings() const = 0;
};

}  // namespace castaway::testbed
