/// Evaluates a localizer on a recorded log: tracking, unknown starts and spliced kidnaps at evenly
/// spaced scans.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "tools/evaluate/stress.hpp"
#include "tools/metrics/localizer_metrics.hpp"
#include "tools/scenario/sections/scenario.hpp"

namespace castaway::testbed {

/// Trials of an evaluation.
struct EvaluationConfig {
  int starts = 24;               ///< Number of unknown starts.
  int kidnaps = 24;              ///< Number of spliced kidnaps.
  double window_s = 60.0;        ///< [s] Length of every start trial, and of the part of a kidnap
                                 ///< trial after the kidnap.
  int scans_before_kidnap = 30;  ///< Scans tracked from a known start before a kidnap.
  bool tracking = true;          ///< Also track the whole log from its true start.
  StressConfig stress;
  std::uint64_t seed = 1;
};

/// Throws std::invalid_argument if a value is out of range.
void validate(const EvaluationConfig& config);

/// Summary of the trials of one kind.
struct TrialSummary {
  int trials = 0;
  int recovered = 0;
  std::vector<double> time_s;      ///< [s] Times of the recoveries, ascending.
  std::vector<double> distance_m;  ///< [m] Distances driven until the recoveries, ascending.
};

/// Results of one localizer on one log.
struct EvaluationRow {
  std::string log;
  std::string localizer;
  std::optional<Statistics> tracking_m;    ///< [m] Position error from the true start.
  std::optional<Statistics> tracking_yaw;  ///< [rad]
  TrialSummary starts;
  TrialSummary kidnaps;
  std::int64_t scans = 0;                 ///< Scored scans of starts and kidnaps.
  std::int64_t wrong_scans = 0;           ///< Scans of these that are wrong without the alarm.
  double longest_wrong_s = 0.0;           ///< [s] Longest uninterrupted time of such scans.
  Calibration calibration;                ///< Over the same scans, if they have an estimate.
  std::vector<double> detection_delay_s;  ///< [s] From each kidnap to the alarm or the right pose,
                                          ///< ascending.
  int false_alarms = 0;      ///< Alarms while right, in all trials and tracking together.
  double watched_s = 0.0;    ///< [s] Time in which no alarm was due.
  double cpu_mean_ms = 0.0;  ///< [ms] Mean CPU time per scan, over starts and kidnaps.
  double cpu_max_ms = 0.0;   ///< [ms] Maximum CPU time of a scan.
};

/// False alarms per hour of watched time; nothing if no time was watched.
std::optional<double> false_alarms_per_h(const EvaluationRow& row);

/// A log with its map.
struct RecordedPlace {
  std::string name;
  Frames frames;
  RosMap map;
};

/// Reads a log and its map from a folder. The log is the first by name of `log`, `*.log`,
/// `*.carmen` and `*.clf` (each also with `.gz`), or else a bag (`*.mcap`, `bag/`). The map is
/// `map.yaml`, `map/map.yaml`, else the only .yaml file, else the bag's map. castaway's own run
/// folders with `outputs.carmen` or `outputs.bag` qualify. Throws std::runtime_error naming what is
/// missing.
RecordedPlace load_recorded_place(const std::string& folder);

/// Runs all trials of one localizer. Trials begin at evenly spaced scans; a kidnap jumps from a
/// place half a log away. `on_trial` is called after each trial.
EvaluationRow evaluate(
    const RecordedPlace& place, const LocalizerSpec& localizer, const EvaluationConfig& config,
    const std::function<void()>& on_trial = [] {});

}  // namespace castaway::testbed
