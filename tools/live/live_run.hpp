/// A simulated run that goes on step by step, and to which events are added.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tools/live/live_event.hpp"
#include "tools/run/loop.hpp"
#include "tools/scenario/scenario_file.hpp"
#include "tools/scene/page_scene.hpp"
#include "tools/sources/shared_worlds.hpp"
#include "tools/sources/simulator_source.hpp"

namespace castaway::testbed {

/// Makes the sink that hears of a run; `radius` [m]: of the robot.
using LiveSinkMaker =
    std::function<std::unique_ptr<RunSink>(const RunInfo& info, const RosMap& map, double radius)>;

/// A run without an end. Played again from `scenario`, it gives the same data.
class LiveRun {
 public:
  /// Builds the run; `base` is the folder of the scenario's file. Throws as `build_simulation` and
  /// `build_localizers`.
  LiveRun(const LoadedScenario& loaded, const std::filesystem::path& base, SharedWorlds& worlds,
          const LiveSinkMaker& make_sink);

  /// Plays the next delivery. Returns false once simulated time ends, after 100 days.
  bool step();
  /// Stamp of the last delivery.
  [[nodiscard]] Stamp now() const { return loop_->now(); }
  /// True pose of base now, which may be a physics step ahead of the last delivery.
  [[nodiscard]] SE2 true_pose() const { return source_->true_pose(); }
  /// Height, roll and pitch of base now.
  [[nodiscard]] Eigen::Isometry3d T_footprint_base() const { return source_->T_footprint_base(); }
  /// What can be seen, people included, as JSON (`page_scene_json`).
  [[nodiscard]] std::string scene();
  /// Estimates carried on by odometry to the last reading; nothing of a localizer without one.
  [[nodiscard]] std::vector<std::optional<SE2>> estimates() const { return loop_->estimates(); }

  /// Adds an event now; see `read_live_event`. Returns its time. Throws std::runtime_error or
  /// std::invalid_argument of one line if it is impossible.
  Stamp add(const std::string& event);
  /// The world as it is now.
  [[nodiscard]] const sim::WorldSpec& world() const { return source_->world(); }
  /// The scenario with all events that were added, ending now.
  [[nodiscard]] std::string scenario() const;

 private:
  [[nodiscard]] Stamp time_of(const std::string& event) const;
  void apply(const EventSpecs& specs);

  YamlNode scenario_;
  std::vector<sim::LidarConfig> lidars_;
  PageScene scene_;
  std::vector<NamedLocalizer> localizers_;
  std::vector<std::unique_ptr<RunSink>> sinks_;
  std::unique_ptr<SimulatorSource> source_;
  std::unique_ptr<Loop> loop_;
};

}  // namespace castaway::testbed
