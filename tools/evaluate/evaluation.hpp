/// Judges a localizer on a recorded log: tracking, unknown starts and spliced kidnaps at evenly
/// spaced places.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "tools/evaluate/stress.hpp"
#include "tools/metrics/localizer_metrics.hpp"
#include "tools/scenario/sections/scenario.hpp"

namespace castaway::testbed {

/// What is tried.
struct EvaluationConfig {
  int starts = 24;               ///< Unknown starts.
  int kidnaps = 24;              ///< Spliced kidnaps.
  double window_s = 60.0;        ///< [s] Of every start and after every kidnap.
  int scans_before_kidnap = 30;  ///< Scans tracked from a known start before a kidnap.
  bool tracking = true;          ///< The whole log from its true start, too.
  StressConfig stress;
  std::uint64_t seed = 1;
};

/// Throws std::invalid_argument where a figure is out of its range.
void validate(const EvaluationConfig& config);

/// Trials of one kind, put together.
struct TrialSummary {
  int trials = 0;
  int recovered = 0;
  std::vector<double> time_s;      ///< [s] Of those recovered, ascending.
  std::vector<double> distance_m;  ///< [m] Of those recovered, ascending.
};

/// One localizer on one log.
struct EvaluationRow {
  std::string log;
  std::string localizer;
  std::optional<Statistics> tracking_m;    ///< [m] Position error from the true start.
  std::optional<Statistics> tracking_yaw;  ///< [rad]
  TrialSummary starts;
  TrialSummary kidnaps;
  std::int64_t scans = 0;                 ///< Of starts and kidnaps, scored ones.
  std::int64_t wrong_scans = 0;           ///< Of those: wrong while it said that it was right.
  double longest_wrong_s = 0.0;           ///< [s] Longest time of that without a pause.
  Calibration calibration;                ///< Of the same scans, those with an estimate.
  std::vector<double> detection_delay_s;  ///< [s] From kidnaps to alarm or right pose, ascending.
  int false_alarms = 0;      ///< Raised while right, starts, kidnaps and tracking together...
  double watched_s = 0.0;    ///< [s] ...in so much time in which none was due.
  double cpu_mean_ms = 0.0;  ///< [ms] CPU time of a scan, over starts and kidnaps.
  double cpu_max_ms = 0.0;   ///< [ms]
};

/// False alarms per hour; nothing where no time was watched.
std::optional<double> false_alarms_per_h(const EvaluationRow& row);

/// A log with its map.
struct RecordedPlace {
  std::string name;
  Frames frames;
  RosMap map;
};

/// Reads a folder that holds a log (`log`, `*.log`, `*.carmen`, `*.clf`, each also with `.gz`; the
/// first by name), or else a bag (`*.mcap`, `bag/`), and a map (`map.yaml`, `map/map.yaml`, else
/// the only .yaml file, else the bag's). castaway's own run folders with `outputs.carmen` or
/// `outputs.bag` are such folders. Throws std::runtime_error naming what is missing.
RecordedPlace load_recorded_place(const std::string& folder);

/// Runs all trials of one localizer. Trials are at evenly spaced scans; a kidnap jumps from half a
/// log away. `on_trial` is called after each.
EvaluationRow evaluate(
    const RecordedPlace& place, const LocalizerSpec& localizer, const EvaluationConfig& config,
    const std::function<void()>& on_trial = [] {});

}  // namespace castaway::testbed
