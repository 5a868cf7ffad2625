/// recording.gz: the data that the player shows of a run over time.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "tools/base/bytes/varint.hpp"
#include "tools/base/files/file.hpp"
#include "tools/outputs/records/recording.hpp"
#include "tools/run/run_sink.hpp"

namespace castaway::testbed {

/// Amount of data in a recording.
struct RecordingConfig {
  double robot_radius_m = 0.2;    ///< [m] Radius of the outlines of robot and estimates.
  double scan_every_s = 0.0;      ///< [s] Period at which scans are kept; 0 keeps all.
  double detail_every_s = 0.0;    ///< [s] Period at which beams, particles and people are kept; 0:
                                  ///< at all scans.
  std::size_t most_beams = 360;   ///< Maximum per scan.
  std::size_t most_points = 300;  ///< Maximum number of particles per localizer and scan.
  std::string scene{};            ///< JSON of what can be seen (`page_scene_json`); empty: none.
  std::shared_ptr<const LevelMaps> levels{};  ///< Null: the run is on one floor.
};

/// Period [s] of details that gives at most about 6000 of them in a run of `duration_s`, so that
/// the page of a long run is no larger than that of ten minutes.
double detail_period(double duration_s);

/// Period [s] of scans that gives at most about 60 000 per lidar.
double scan_period(double duration_s);

/// Writes the recording: poses, beliefs and flags at all scans; beams, particles and people at
/// scans that are details. Sections are columns of numbers (`IntColumn`) with one entry per scan in
/// order of delivery, unless noted otherwise:
///   map                      `pack_cells`
///   scene                    `RecordingConfig::scene`; absent if that is empty
///   time                     stamp of the scan
///   flags                    1: the truth is known; 2: a kidnap tore the scan
///   truth/x /y /yaw          if unknown, the last known values
///   truth/z /roll /pitch K/z level/K   in a run on several floors (`heights` in the header): of
///                            base (if its height is known), of answers, and `pack_cells` of
///                            floor K
///   K/flags                  of localizer K = 0, 1...: 1: it has an answer; 2: it says it is lost
///   K/x /y /yaw /quality /probability   if it has no answer, the last values
///   K/sigma /sigma_yaw       sqrt((var_x + var_y) / 2), sqrt(var_yaw)
///   K/populations /particles their numbers
///   detail                   one entry per detail: index of its scan
///   beams people K/points    blocks of `recording_blocks.hpp`, one per detail
///   beams/sizes ...          one entry per detail: size of its block in bytes
class RecordingSink final : public RunSink {
 public:
  RecordingSink(const std::filesystem::path& run_folder, const RunInfo& info, const RosMap& map,
                const RecordingConfig& config);

  void on_event(const RunEvent& event) override;
  void on_odometry(const OdometryFrame&) override {}
  void on_scan(const ScanRecord& record) override;
  void finish(Stamp end, const RunTiming& timing) override;

 private:
  [[nodiscard]] bool is_torn(const ScanRecord& record) const;
  static bool is_due(const ScanRecord& record, double every_s, std::map<std::string, Stamp>& next);
  void add_pose(const std::string& prefix, const SE2& pose);
  void repeat_pose(const std::string& prefix);
  void add_true_height(const ScanRecord& record);
  void add_heights(const ScanRecord& record);
  void add_localizer(std::size_t index, const LocalizerRecord& localizer);
  void add_belief(const std::string& prefix, const localization::Estimate& estimate);
  void add_detail(const ScanRecord& record);
  void add_block(const std::string& name, const std::string& block);

  AtomicFile file_;
  RecordingConfig config_;
  nlohmann::ordered_json header_;
  bool heights_;
  std::vector<RecordingSection> fixed_;       ///< Sections that do not grow: the maps.
  std::map<std::string, IntColumn> columns_;  ///< By name.
  std::map<std::string, std::string> blocks_;
  std::vector<RunEvent> kidnaps_;
  std::map<std::string, Stamp> next_scan_;    ///< By lidar.
  std::map<std::string, Stamp> next_detail_;  ///< By lidar.
  std::int64_t scans_ = 0;
};

}  // namespace castaway::testbed
