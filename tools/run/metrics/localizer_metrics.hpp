/// Metrics of one localizer over a run. docs/metrics.md defines them for users.
///
/// Rows are scans. A row is scored if its truth is known. Truth and estimate both refer to the
/// stamp of the first beam. A torn scan (a kidnap happened between its first and last beam) is not
/// scored, since its beams were taken at two places. Recoveries and alarms are timed by the answer,
/// which exists once the last beam is measured.
#pragma once

#include <optional>
#include <vector>

#include "tools/run/metrics/ape.hpp"
#include "tools/run/metrics/calibration.hpp"
#include "tools/run/metrics/discrimination.hpp"
#include "tools/run/metrics/output_jumps.hpp"
#include "tools/run/metrics/recovery.hpp"
#include "tools/run/metrics/statistics/statistics.hpp"

namespace castaway::testbed {

/// Version of these definitions; metrics of different versions must not be compared. Version 1 had
/// no intervals, availability, jumps, discrimination and APE.
inline constexpr int kMetricsVersion = 2;

/// Metrics of one localizer. A value is missing if there was nothing to measure.
struct LocalizerMetrics {
  bool has_truth = false;  ///< Whether any true pose is known; nothing is scored without.
  /// Over all rows with truth and estimate. Intervals are by bootstrap over blocks of 5 s.
  std::optional<Statistics> position_error_m;
  std::optional<Statistics> yaw_error_rad;
  /// Position error outside the times from a kidnap (or unknown start) to its recovery, or without
  /// a recovery to the next kidnap or the end.
  std::optional<Statistics> tracking_error_m;

  /// Number of kidnaps and unknown starts with at least 5 s until the next kidnap or the end.
  int events = 0;
  /// Number of these events after which the error stays below 0.5 m and 0.35 rad from some row on
  /// that was answered at least 5 s before the end of the window. A row without an estimate is
  /// wrong.
  int recovered = 0;
  std::optional<double> success;                  ///< recovered / events, with its Wilson interval.
  std::optional<Statistics> recovery_time_s;      ///< From the event to that row; recoveries only.
  std::optional<Statistics> recovery_distance_m;  ///< Distance driven meanwhile; recoveries only.

  /// Share of the scored rows with an estimate that are wrong (error of at least 0.5 m or 0.35 rad)
  /// without the alarm (lost == false).
  std::optional<double> wrong_lock_share;

  double wrong_lock_s = 0.0;          ///< [s] Duration of wrong lock; each row counts until the
                                      ///< next one, the last one until the end (`WrongTime`).
  double longest_wrong_lock_s = 0.0;  ///< [s] Longest uninterrupted wrong lock.
  /// Share of the scored rows that have an estimate and no alarm.
  std::optional<double> availability;
  OutputJumps jumps;

  /// From the start of a kidnap to the first row that raises the alarm or is right. Only kidnaps
  /// that are counted in `events` and are noticed before the next one.
  std::optional<Statistics> detection_delay_s;
  int undetected = 0;  ///< Kidnaps counted in `events` that are not noticed.
  /// Alarms per hour that were raised while the output was right. Excluded are the times that
  /// `tracking_error_m` excludes and the 5 s after a kidnap, when an alarm is the correct response.
  std::optional<double> false_alarms_per_h;
  int false_alarms = 0;    ///< Number of false alarms.
  double watched_s = 0.0;  ///< [s] Time in which an alarm is false; 0 if there is none.

  /// Stated probability against the outcome, over all rows with truth and estimate.
  Calibration calibration;
  /// Discrimination by quality, stated probability and covariance, over the same rows.
  Discrimination discrimination;
  /// As evo computes it from the run's TUM files. Torn scans are included, since evo does not know
  /// about kidnaps.
  std::optional<Ape> ape;

  std::vector<RecoveryWindow> windows;  ///< The windows from which the recovery metrics are
                                        ///< computed.
};

/// Computes all metrics of one localizer. `end`: the end of the run.
LocalizerMetrics measure(const std::vector<MetricRow>& all, const std::vector<RunEvent>& events,
                         bool known_start, Stamp end, const RecoveryConfig& config = {});

}  // namespace castaway::testbed
