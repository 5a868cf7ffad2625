/// What the pages hear of a live run.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "sim/world/world.hpp"
#include "tools/base/formats/level_map.hpp"
#include "tools/base/formats/ros_map.hpp"
#include "tools/run/run_sink.hpp"

namespace castaway::testbed {

/// Where robot and estimates are between scans.
struct LivePoses {
  Stamp now{};
  std::optional<SE2> T_map_base_true;         ///< Nothing if it is unknown.
  std::vector<std::optional<SE2>> estimates;  ///< By localizer, carried on by odometry.
  /// Height, roll and pitch of base.
  Eigen::Isometry3d T_footprint_base = Eigen::Isometry3d::Identity();
};

/// Gathers what happened since the last frame.
class LiveFeed final : public RunSink {
 public:
  LiveFeed(const RunInfo& info, const RosMap& map, double robot_radius_m);

  void on_event(const RunEvent& event) override;
  void on_odometry(const OdometryFrame&) override {}
  void on_scan(const ScanRecord& record) override;
  void finish(Stamp, const RunTiming&) override {}

  /// Tells pages of a world's doors: [{name, outline, z, closed}], `closed` being the
  /// outline of its leaf when it is closed; otherwise as in `change_entry`.
  void set_doors(const sim::WorldSpec& world);

  /// Tells pages of the floors of a run: `levels` of the header, with `cells` of each, in base64.
  void set_levels(const LevelMaps& levels);

  /// Tells pages that a log of so many scans is played: `recorded` of the header.
  void set_recorded(std::size_t scans) { header_["recorded"] = {{"scans", scans}}; }

  /// The header of a recording (`recording_header`) with `cells`: what is known of the map
  /// (`known_part`) as `pack_cells`, in base64, `doors`, and the `notes` of the run.
  [[nodiscard]] nlohmann::ordered_json hello() const;

  /// A frame: the length of its JSON in four bytes, lowest first, the JSON, and blocks of bytes.
  ///   now          [s]
  ///   truth        [x, y, yaw], or null
  ///   lift         [height, roll, pitch] of base; absent while it stands on level floor
  ///   estimates    the same for each localizer, or null
  ///   first        number of the first of `scans`: those of a run have the numbers 0, 1, 2...;
  ///                what was told with this number and later ones never happened
  ///   scans        those since the last frame: [t, torn, truth, localizers], of each localizer
  ///                null or [x, y, yaw, lost, quality, probability, sigma, sigma_yaw], and the
  ///                numbers of its populations and particles; on several floors, the truth is
  ///                [x, y, yaw, z, roll, pitch], and z follows an answer's sigma_yaw
  ///   lidars       as in the header of a recording
  ///   blocks       sizes of the blocks of the newest scan: beams, people, populations of each
  ///                localizer (`recording_blocks.hpp`); empty without a scan
  std::string take_frame(const LivePoses& poses);

  /// Scans so far.
  [[nodiscard]] std::size_t scans() const { return count_; }
  /// Scans that were not told yet.
  [[nodiscard]] std::size_t untold_scans() const { return scans_.size(); }
  /// They, without anything else: {"said": "history", "first", "scans"}, as in a frame.
  nlohmann::ordered_json take_scans();

  /// A hand drives from `at` on: {"v", "w"}; empty: the route does again.
  void on_drive(Stamp at, const nlohmann::ordered_json& command);
  [[nodiscard]] bool has_events() const { return !events_.empty(); }
  /// True if one of them is a change of the world.
  [[nodiscard]] bool has_world_news() const { return world_news_; }
  /// The events since the last call: {"said": "events", "first", "events"}, numbered like scans,
  /// each {time, kind, detail, localizer, from, to}, with `change` (`change_entry`) where the world
  /// changed, and `drive` where a hand drives.
  nlohmann::ordered_json take_events();

 private:
  void set_blocks(const ScanRecord& record);
  void add_event(nlohmann::ordered_json event);

  nlohmann::ordered_json header_;
  std::string cells_;
  std::vector<RunEvent> kidnaps_;  ///< The latest few, for torn scans.
  nlohmann::ordered_json events_ = nlohmann::ordered_json::array();
  nlohmann::ordered_json scans_ = nlohmann::ordered_json::array();
  std::vector<std::string> blocks_;
  std::size_t count_ = 0;        ///< Scans,
  std::size_t event_count_ = 0;  ///< and events since the beginning.
  bool world_news_ = false;
};

}  // namespace castaway::testbed
