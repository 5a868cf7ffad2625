/// What pages of a live run play: a simulated run, or a recorded log.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/world/world.hpp"
#include "tools/base/formats/level_map.hpp"
#include "tools/base/formats/ros_map.hpp"
#include "tools/run/run_sink.hpp"

namespace castaway::testbed {

/// Makes the sink that hears of a run; `radius` [m]: of the robot.
using LiveSinkMaker =
    std::function<std::unique_ptr<RunSink>(const RunInfo& info, const RosMap& map, double radius)>;

/// A run that goes on step by step, and to which events are added. Played again from `saved`, it
/// gives the same data.
class LivePlay {
 public:
  virtual ~LivePlay() = default;

  /// Plays the next delivery. Returns false at the end.
  virtual bool step() = 0;
  /// Stamp of the last delivery.
  [[nodiscard]] virtual Stamp now() const = 0;
  /// True pose of base now; nothing if it is unknown.
  [[nodiscard]] virtual std::optional<SE2> true_pose() const = 0;
  /// Height, roll and pitch of base now.
  [[nodiscard]] virtual Eigen::Isometry3d T_footprint_base() const = 0;
  /// What can be seen, people included, as JSON (`page_scene_json`); empty: nothing is known of it.
  [[nodiscard]] virtual std::string scene() = 0;
  /// Estimates carried on by odometry to the last reading; nothing of a localizer without one.
  [[nodiscard]] virtual std::vector<std::optional<SE2>> estimates() const = 0;

  /// Ends the localizers that are programs; nothing but the destructor may follow.
  virtual void finish_localizers() = 0;

  /// Adds an event now, as JSON: {"kidnap": {...}}. Returns its time. Throws std::runtime_error or
  /// std::invalid_argument of one line if it is impossible.
  virtual Stamp add(const std::string& event) = 0;
  /// The world as it is now; nullptr if there is none.
  [[nodiscard]] virtual const sim::WorldSpec* world() const = 0;
  /// The floors of a run on several; null: it is on one.
  [[nodiscard]] virtual const LevelMaps* levels() const { return nullptr; }
  /// Scans of the log; nothing if this is none.
  [[nodiscard]] virtual std::optional<std::size_t> recorded_scans() const = 0;
  /// YAML that plays the run again, with all events that were added, until now.
  [[nodiscard]] virtual std::string saved() const = 0;
};

}  // namespace castaway::testbed
