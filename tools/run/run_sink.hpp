/// The seam between a run and its outputs: logs, metrics, pictures, reports.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "castaway/localizer.hpp"
#include "tools/run/frame.hpp"
#include "tools/run/outside_use.hpp"

namespace castaway::testbed {

/// One localizer's answer to a scan.
struct LocalizerRecord {
  std::string name;  ///< As in the scenario and in file names.
  std::optional<localization::Estimate>
      estimate;  ///< At the scan's stamp; nothing if there is none.
  localization::Diagnostics diagnostics;
  std::chrono::nanoseconds
      update_cpu{};  ///< CPU time of this scan and of the odometry since the one before.
  std::map<std::string, std::chrono::nanoseconds>
      stage_cpu;  ///< The same, by stage of the localizer.
};

/// The state of a run after a scan.
struct ScanRecord {
  Stamp stamp{};                      ///< The scan's stamp.
  Stamp delivered{};                  ///< Time of the last beam, when the scan is delivered.
  std::optional<TruePose> true_pose;  ///< At the scan's stamp.
  PeopleTruth people;                 ///< At the scan's stamp.
  SE2 T_odom_base;                    ///< Newest odometry at delivery.
  LaserScan scan;
  ScanTruth truth;                          ///< Ground truth of the scan.
  std::vector<LocalizerRecord> localizers;  ///< Same order in every record of a run.

  /// True if the true pose is known, with its height.
  [[nodiscard]] bool has_heights() const { return true_pose && true_pose->T_footprint_base; }
  /// [m] How far an estimate is above the robot; 0 on one floor. A planar estimate is at z = 0.
  [[nodiscard]] double height_error(const localization::Estimate& estimate) const {
    if (!has_heights()) return 0.0;
    return (estimate.footing ? estimate.footing->z : 0.0) - true_pose->z();
  }
};

/// [m] Error of an estimate against the true pose of its scan, which is known: planar on one floor,
/// else with height.
inline double position_error(const ScanRecord& record, const localization::Estimate& estimate) {
  const double planar = localization::distance(record.true_pose->T_map_base, estimate.T_map_base);
  const double above = record.height_error(estimate);
  return above == 0.0 ? planar : std::hypot(planar, above);
}

/// Cost of a run. The only wall-clock figures that sinks receive.
struct RunTiming {
  double wall_s = 0.0;                  ///< [s] Whole run, loading included.
  std::map<std::string, double> cpu_s;  ///< By stage: physics, lidar, people, localizers, sinks.
  double load_s = 0.0;                  ///< [s] Loading of world, map, robot or log.
  std::map<std::string, OutsideUse> outside{};  ///< By localizer, of those with other processes.
};

/// How the world of a run differs from its map.
struct MapDifference {
  double beams = 0.0;  ///< Share of a lidar's beams that end elsewhere, by more than 0.2 m.
  int moved = 0;       ///< Pieces of furniture.
  int removed = 0;     ///< Pieces of furniture.
  int opened = 0;      ///< Doors.
  int closed = 0;      ///< Doors.
  int added = 0;       ///< Objects.
};

/// Fixed facts of a run, known before its first frame.
struct RunInfo {
  std::string scenario;  ///< Its name.
  std::string world;     ///< World or map name.
  std::string robot;     ///< Robot name, or "recorded".
  std::uint64_t seed = 0;
  bool known_start = true;                       ///< False: the localizers start anywhere.
  std::vector<std::string> localizers;           ///< In order of `ScanRecord::localizers`.
  std::optional<MapDifference> difference = {};  ///< Nothing: no known difference.
  bool heights = false;                          ///< It is on several floors.
  /// Sentences about how the run is otherwise than what it simulates, for summary and report.
  std::vector<std::string> notes{};
};

/// A consumer of a run. Calls come in order: `on_event` and `on_scan` by time, then `finish` once.
class RunSink {
 public:
  virtual ~RunSink() = default;

  virtual void on_event(const RunEvent& event) = 0;
  virtual void on_odometry(const OdometryFrame& frame) = 0;
  virtual void on_scan(const ScanRecord& record) = 0;
  virtual void on_imu(const ImuFrame&) {}
  /// Writes what remains to be written; the run ended at `end`.
  virtual void finish(Stamp end, const RunTiming& timing) = 0;
};

/// Tells a sink of a reading that localizers take as it is.
inline void tell(const ImuFrame& frame, RunSink& sink) { sink.on_imu(frame); }

}  // namespace castaway::testbed
