/// Recovery of a localizer after a kidnap or an unknown start.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "tools/run/metrics/run_rows.hpp"

namespace castaway::testbed {

/// Thresholds for a right output and a recovery.
struct RecoveryConfig {
  double position_m = 0.5;                      ///< [m] The position error of a right output is
                                                ///< below this.
  double yaw_rad = 0.35;                        ///< [rad] The yaw error of a right output is below
                                                ///< this.
  Stamp min_left = std::chrono::seconds(5);     ///< Least time from the answer to the end of its
                                                ///< window.
  Stamp alarm_grace = std::chrono::seconds(5);  ///< For this long after a kidnap an alarm is a
                                                ///< correct response.
};

/// The time from a kidnap (or unknown start) to the next kidnap or the end of the run.
struct RecoveryWindow {
  Stamp taken{};      ///< Start of the kidnap: the robot was lifted.
  Stamp begin{};      ///< End of the kidnap: the robot was put down. Recovery is timed from here.
  Stamp end{};        ///< Start of the next kidnap, or end of the run.
  LossCause cause{};  ///< What it begins with.
  bool unknown_start = false;        ///< False: a kidnap. True also after an operator's order,
                                     ///< which is never scored.
  bool has_truth = true;             ///< False if no true pose is known in the window.
  bool scored = true;                ///< False without truth, or if the window is shorter than
                                     ///< `min_left`, so that no recovery was possible.
  std::optional<Stamp> recovered{};  ///< Answer of the first row from which on all rows up to `end`
                                     ///< are right.
  std::optional<Stamp> noticed{};    ///< First answer that raises the alarm or is right.
  double distance_m = 0.0;           ///< [m] Driven from `begin` to `recovered`.
  double wrong_lock_s = 0.0;         ///< [s] Time since `taken` with a wrong output and no alarm
                                     ///< (`WrongTime`).

  /// [s] From `taken` to `noticed`; nothing for a start and for kidnaps that were not noticed.
  [[nodiscard]] std::optional<double> detection_delay_s() const;

  /// Whether the localizer cannot be expected to track at `stamp`: before its recovery.
  [[nodiscard]] bool is_lost_at(Stamp stamp) const {
    return stamp >= taken && stamp < recovered.value_or(end);
  }
};

/// True if the row has truth and estimate and the error is below the thresholds.
bool is_right(const MetricRow& row, const RecoveryConfig& config);
/// True if the row has truth and estimate, is not right, and raises no alarm.
bool is_wrong_lock(const MetricRow& row, const RecoveryConfig& config);

/// The windows of a run, in order. The window of an unknown start begins at the first row. An order
/// of an operator to the localizer, among `breaks` (`breaks_of`), ends a window.
std::vector<RecoveryWindow> recovery_windows(const std::vector<MetricRow>& rows,
                                             const std::vector<RunEvent>& breaks, bool known_start,
                                             Stamp end, const RecoveryConfig& config);

}  // namespace castaway::testbed
