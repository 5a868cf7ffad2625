/// A recorded log that is played live, and kidnapped by splicing.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tools/live/live_play.hpp"
#include "tools/play/replay/recorded_log.hpp"
#include "tools/ros/topic_writer.hpp"
#include "tools/run/loop.hpp"

namespace castaway::testbed {

/// A replay that goes on step by step. Saved, it is a session for `castaway replay`.
class LiveLog final : public LivePlay {
 public:
  /// Opens the log. Throws as `open_log` and `build_localizers`.
  /// `bridge`: as of `LiveRun`.
  LiveLog(ReplaySession session, const LiveSinkMaker& make_sink, TopicWriter* bridge = nullptr);

  bool step() override;
  [[nodiscard]] Stamp now() const override { return loop_->now(); }
  [[nodiscard]] std::optional<SE2> true_pose() const override { return source_->true_pose(); }
  [[nodiscard]] Eigen::Isometry3d T_footprint_base() const override {
    return source_->T_footprint_base().value_or(Eigen::Isometry3d::Identity());
  }
  [[nodiscard]] const LevelMaps* levels() const override { return log_.levels.get(); }
  [[nodiscard]] std::string scene() override { return {}; }
  [[nodiscard]] std::vector<std::optional<SE2>> estimates() const override {
    return loop_->estimates();
  }
  void finish_localizers() override { (void)loop_->finish_localizers(); }

  /// Events: kidnaps `teleport` with a pose (to the nearest recorded one, on the floor `level` if
  /// it is stated), `teleport` (far away in the log) and `look_alike`; {"splice": {"to_scan":
  /// 900}}; orders to a localizer.
  Stamp add(const std::string& event) override;
  [[nodiscard]] const sim::WorldSpec* world() const override { return nullptr; }
  [[nodiscard]] std::optional<std::size_t> recorded_scans() const override {
    return source_->scans();
  }
  [[nodiscard]] std::string saved() const override;
  /// What was assumed or left out when the log was read, in one sentence each.
  [[nodiscard]] const std::vector<std::string>& warnings() const { return log_.warnings; }

 private:
  [[nodiscard]] std::size_t target_of(const sim::KidnapSpec& kidnap) const;
  void add_orders(const std::string& event);

  ReplaySession session_;
  RecordedLog log_;
  std::vector<YamlNode> orders_;  ///< Events of the session that are orders.
  std::vector<NamedLocalizer> localizers_;
  std::vector<std::unique_ptr<RunSink>> sinks_;
  std::unique_ptr<SplicedSource> source_;
  std::unique_ptr<Loop> loop_;
};

}  // namespace castaway::testbed
