/// Results of an evaluation: of one trial, or the sum over the trials of a log.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "tools/run/metrics/calibration.hpp"

namespace castaway::testbed {

/// Summary of the trials of one kind.
struct TrialSummary {
  int trials = 0;
  int recovered = 0;
  std::vector<double> time_s;      ///< [s] Times of the recoveries; of a log, ascending.
  std::vector<double> distance_m;  ///< [m] Distances driven until the recoveries, likewise.
};

/// Results of one localizer on one log.
struct EvaluationRow {
  std::string log;
  std::string localizer;
  std::optional<double> tracking_m;           ///< [m] Mean position error from the true start.
  std::optional<double> tracking_yaw_rad;     ///< [rad]
  std::optional<double> tracking_no_alarm_m;  ///< [m] `tracking_m` of the scans without the alarm.
  TrialSummary starts;
  TrialSummary kidnaps;
  std::int64_t scans = 0;        ///< Scored scans of starts and kidnaps.
  std::int64_t wrong_scans = 0;  ///< Scans of these that are wrong without the alarm.
  double longest_wrong_s = 0.0;  ///< [s] Longest uninterrupted time of such scans (`WrongTime`).
  Calibration calibration;       ///< Over the same scans, if they have an estimate.
  std::vector<double> detection_delay_s;  ///< [s] From each kidnap to the alarm or the right pose;
                                          ///< of a log, ascending.
  int false_alarms = 0;       ///< Alarms while right, in all trials and tracking together.
  double watched_s = 0.0;     ///< [s] Time in which no alarm was due.
  double cpu_total_ms = 0.0;  ///< [ms] CPU time of all scans of starts and kidnaps.
  std::int64_t updates = 0;   ///< Number of these scans.
  double cpu_max_ms = 0.0;    ///< [ms] Maximum CPU time of a scan.

  /// [ms] Mean CPU time per scan; 0 without scans.
  [[nodiscard]] double cpu_mean_ms() const;
};

/// False alarms per hour of watched time; nothing if no time was watched.
std::optional<double> false_alarms_per_h(const EvaluationRow& row);

/// Adds the results of further trials.
void add(const EvaluationRow& trials, EvaluationRow& sum);

/// Text of a row without names, for transfer between processes: all values exactly.
std::string pack_row(const EvaluationRow& row);
/// Throws std::runtime_error for any other text.
EvaluationRow unpack_row(const std::string& text);

/// What `castaway evaluate --json` prints.
nlohmann::ordered_json to_json(const EvaluationRow& row);

}  // namespace castaway::testbed
