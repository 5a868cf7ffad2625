/// From being lost to being right again.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "tools/metrics/run_rows.hpp"

namespace castaway::testbed {

/// When an output is right and when it has recovered.
struct RecoveryConfig {
  double position_m = 0.5;                      ///< [m] Right: position error below this...
  double yaw_rad = 0.35;                        ///< [rad] ...and yaw error below this.
  Stamp min_left = std::chrono::seconds(5);     ///< A recovery's answer leaves this of its window.
  Stamp alarm_grace = std::chrono::seconds(5);  ///< So long after a kidnap an alarm is its answer.
};

/// The time from a kidnap (or unknown start) to the next kidnap or the end of the run.
struct RecoveryWindow {
  Stamp taken{};       ///< The kidnap began: the robot was lifted.
  Stamp begin{};       ///< It was over: the robot stands, and recovery is timed from here.
  Stamp end{};         ///< The next one begins, or the run is over.
  std::string kind{};  ///< Of the kidnap, as `RunEvent::detail`; "start" of an unknown start.
  bool unknown_start = false;  ///< False: a kidnap.
  bool scored = true;          ///< False: shorter than `min_left`; nobody could recover.
  std::optional<Stamp>
      recovered{};                 ///< Answer of the first row after which all to `end` are right.
  std::optional<Stamp> noticed{};  ///< First answer that raises the alarm or is right.
  double distance_m = 0.0;         ///< Driven from `begin` to `recovered`. [m]
  double wrong_lock_s = 0.0;       ///< Of the window from `taken` on: output wrong, no alarm. [s]

  /// From `taken` to `noticed`; nothing for a start, and where it was not noticed. [s]
  [[nodiscard]] std::optional<double> detection_delay_s() const;

  /// The part in which the localizer cannot be held to be tracking: up to its recovery.
  [[nodiscard]] bool is_lost_at(Stamp stamp) const {
    return stamp >= taken && stamp < recovered.value_or(end);
  }
};

/// True if the row has truth and estimate and the error is small.
bool is_right(const MetricRow& row, const RecoveryConfig& config);

/// The windows of a run, in order. An unknown start's window begins at the first row.
std::vector<RecoveryWindow> recovery_windows(const std::vector<MetricRow>& rows,
                                             const std::vector<RunEvent>& kidnaps, bool known_start,
                                             Stamp end, const RecoveryConfig& config);

}  // namespace castaway::testbed
