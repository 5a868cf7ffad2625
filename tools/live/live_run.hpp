/// A simulated run that goes on step by step, and to which events are added.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tools/build/scene/page_scene.hpp"
#include "tools/build/shared_worlds.hpp"
#include "tools/build/simulator_source.hpp"
#include "tools/live/live_event.hpp"
#include "tools/live/live_play.hpp"
#include "tools/ros/topic_writer.hpp"
#include "tools/run/loop.hpp"
#include "tools/scenario/scenario_file.hpp"

namespace castaway::testbed {

/// A run without an end. Saved, it is a scenario.
class LiveRun final : public LivePlay {
 public:
  /// Builds the run; `base` is the folder of the scenario's file. `bridge`: takes its messages;
  /// null: nobody does. Throws as `build_simulation` and `build_localizers`.
  LiveRun(const LoadedScenario& loaded, const std::filesystem::path& base, SharedWorlds& worlds,
          const LiveSinkMaker& make_sink, TopicWriter* bridge = nullptr);

  /// Simulated time ends after 100 days.
  bool step() override;
  [[nodiscard]] Stamp now() const override { return loop_->now(); }
  /// It may be a physics step ahead of the last delivery.
  [[nodiscard]] std::optional<SE2> true_pose() const override { return source_->true_pose(); }
  [[nodiscard]] Eigen::Isometry3d T_footprint_base() const override {
    return source_->T_footprint_base();
  }
  [[nodiscard]] const LevelMaps* levels() const override { return levels_.get(); }
  [[nodiscard]] std::string scene() override;
  [[nodiscard]] std::vector<std::optional<SE2>> estimates() const override {
    return loop_->estimates();
  }
  void finish_localizers() override { (void)loop_->finish_localizers(); }

  /// See `read_live_event`.
  Stamp add(const std::string& event) override;
  [[nodiscard]] const sim::WorldSpec* world() const override { return &source_->world(); }
  [[nodiscard]] std::optional<std::size_t> recorded_scans() const override { return std::nullopt; }
  [[nodiscard]] std::string saved() const override;

 private:
  [[nodiscard]] Stamp time_of(const std::string& event) const;
  void apply(const EventSpecs& specs);

  YamlNode scenario_;
  std::vector<sim::LidarConfig> lidars_;
  PageScene scene_;
  std::vector<NamedLocalizer> localizers_;
  std::vector<std::unique_ptr<RunSink>> sinks_;
  std::unique_ptr<const LevelMaps> levels_;  ///< Null on one floor.
  std::unique_ptr<SimulatorSource> source_;
  std::unique_ptr<Loop> loop_;
};

}  // namespace castaway::testbed
