/// How well a localizer did in a run. docs/metrics.md says the same for users.
///
/// Rows are scans. A row is scored if its truth is known; the truth of a scan is that at the stamp
/// of its first beam, and so is the estimate's. A scan that a kidnap tore is not scored: its beams
/// saw two places. The answer is there when the last beam is:
/// recoveries and alarms are timed by that.
#pragma once

#include <optional>
#include <vector>

#include "tools/metrics/ape.hpp"
#include "tools/metrics/calibration.hpp"
#include "tools/metrics/discrimination.hpp"
#include "tools/metrics/output_jumps.hpp"
#include "tools/metrics/recovery.hpp"
#include "tools/metrics/statistics/statistics.hpp"

namespace castaway::testbed {

/// Version of these definitions; figures of two versions must not be compared. 1: without
/// intervals, availability, jumps, discrimination and APE.
inline constexpr int kMetricsVersion = 2;

/// Figures of one localizer; nothing where there is nothing to measure.
struct LocalizerMetrics {
  /// Over all rows with truth and estimate. Intervals: bootstrap over blocks of 5 s.
  std::optional<Statistics> position_error_m;
  std::optional<Statistics> yaw_error_rad;
  /// Position error outside the times from a kidnap (or unknown start) to its recovery; where there
  /// is none, to the next kidnap or the end.
  std::optional<Statistics> tracking_error_m;

  /// Over kidnaps and the unknown start that leave at least 5 s to the next kidnap or the end.
  int events = 0;
  /// Those after which the error stays below 0.5 m and 0.35 rad from some row on, answered at least
  /// 5 s before the end of the window. A row without an estimate is wrong.
  int recovered = 0;
  std::optional<double> success;              ///< recovered / events, interval of Wilson's.
  std::optional<Statistics> recovery_time_s;  ///< From the event to that row, recovered ones only.
  std::optional<Statistics> recovery_distance_m;  ///< Driven meanwhile, recovered ones only.

  /// Share of the scored rows with an estimate whose output says it is right (lost == false) while
  /// it is not: error from 0.5 m or from 0.35 rad on.
  std::optional<double> wrong_lock_share;

  double wrong_lock_s = 0.0;          ///< [s] That, each row standing for the time to the next...
  double longest_wrong_lock_s = 0.0;  ///< [s] ...and its longest stretch without a pause.
  /// Share of the scored rows that have an estimate and no alarm.
  std::optional<double> availability;
  OutputJumps jumps;

  /// From a kidnap's beginning to the first row that raises the alarm or is right; kidnaps that are
  /// counted in `events` and are noticed before the next one.
  std::optional<Statistics> detection_delay_s;
  int undetected = 0;  ///< Kidnaps counted in `events` that are not noticed.
  /// Alarms raised while the output was right, outside of the times that `tracking_error_m` leaves
  /// out and of the 5 s after a kidnap (an alarm then is its answer), per hour of the remaining
  /// time.
  std::optional<double> false_alarms_per_h;
  int false_alarms = 0;    ///< Those alarms...
  double watched_s = 0.0;  ///< ...and that time; 0 where there is no figure. [s]

  /// Stated probability against what came of it, over all rows with truth and estimate.
  Calibration calibration;
  /// How well quality, stated probability and covariance tell right from wrong, over the same rows.
  Discrimination discrimination;
  /// As evo computes it from the run's TUM files: torn scans are in, for evo knows of no kidnaps.
  std::optional<Ape> ape;

  std::vector<RecoveryWindow> windows;  ///< What the recovery figures are made of.
};

/// All that is measured of one localizer. `end`: the end of the run.
LocalizerMetrics measure(const std::vector<MetricRow>& all, const std::vector<RunEvent>& events,
                         bool known_start, Stamp end, const RecoveryConfig& config = {});

}  // namespace castaway::testbed
