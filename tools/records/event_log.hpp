/// The events of a run, those found afterwards included.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/metrics/localizer_metrics.hpp"
#include "tools/records/run_history.hpp"

namespace castaway::testbed {

/// A line of events.csv.
struct LoggedEvent {
  RunEvent event;
  std::string localizer;               ///< Empty: it happened to the robot.
  std::optional<double> time_s{};      ///< Of a recovery: since the kidnap or the start.
  std::optional<double> distance_m{};  ///< Of a recovery: driven meanwhile.
};

/// Events of the run, alarms and recoveries, by time; at one time in this order. `metrics`: of each
/// localizer of `history`.
std::vector<LoggedEvent> log_events(const RunHistory& history,
                                    const std::vector<LocalizerMetrics>& metrics);

}  // namespace castaway::testbed
