/// recording.gz: what a player shows of a run along time.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tools/files/file.hpp"
#include "tools/formats/varint.hpp"
#include "tools/records/recording.hpp"
#include "tools/run/run_sink.hpp"

namespace castaway::testbed {

/// How much a recording keeps.
struct RecordingConfig {
  double robot_radius_m = 0.2;    ///< [m] Of the outlines that stand for robot and estimates.
  double scan_every_s = 0.0;      ///< [s] Scans are kept this often; 0: all of them.
  double detail_every_s = 0.0;    ///< [s] Beams, particles and people this often; 0: at all scans.
  std::size_t most_beams = 360;   ///< Of a scan.
  std::size_t most_points = 300;  ///< Particles of a localizer at a scan.
};

/// Seconds between details so that a run of `duration_s` has some 6000 of them at most: a page of a
/// long run stays as small as that of ten minutes. [s]
double detail_period(double duration_s);

/// Likewise for scans, some 60 000 of a lidar. [s]
double scan_period(double duration_s);

/// Writes the recording: poses, beliefs and flags at all scans; beams, particles and people at
/// those that are details. Sections, all columns of numbers (`IntColumn`) with one entry a scan in
/// order of delivery unless said otherwise:
///   map                      `pack_cells`
///   time                     the scan's stamp
///   flags                    1: the truth is known; 2: a kidnap tore the scan
///   truth/x /y /yaw          the last known where it is not
///   K/flags                  of localizer K = 0, 1...: 1: it has an answer; 2: it says it is lost
///   K/x /y /yaw /quality /probability   the last ones where it has none
///   K/sigma /sigma_yaw       sqrt((var_x + var_y) / 2), sqrt(var_yaw)
///   K/populations /particles how many there are
///   detail                   one entry a detail: which scan
///   beams people K/points    blocks of `recording_blocks.hpp`, one a detail
///   beams/sizes ...          one entry a detail: bytes of its block
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
  [[nodiscard]] std::size_t lidar_of(const LaserScan& scan, std::size_t stride);
  void add_pose(const std::string& prefix, const SE2& pose);
  void repeat_pose(const std::string& prefix);
  void add_localizer(std::size_t index, const LocalizerRecord& localizer);
  void add_belief(const std::string& prefix, const localization::Estimate& estimate);
  void add_detail(const ScanRecord& record);
  void add_block(const std::string& name, const std::string& block);

  AtomicFile file_;
  RecordingConfig config_;
  nlohmann::ordered_json header_;
  std::vector<RecordingSection> fixed_;       ///< The map.
  std::map<std::string, IntColumn> columns_;  ///< By name.
  std::map<std::string, std::string> blocks_;
  std::vector<RunEvent> kidnaps_;
  std::map<std::string, Stamp> next_scan_;    ///< By lidar.
  std::map<std::string, Stamp> next_detail_;  ///< By lidar.
  std::int64_t scans_ = 0;
};

}  // namespace castaway::testbed
