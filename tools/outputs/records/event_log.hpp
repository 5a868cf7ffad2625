/// The events of a run, including those derived after the run.
#pragma once

#include <optional>
#include <vector>

#include "tools/outputs/records/run_history.hpp"
#include "tools/run/metrics/localizer_metrics.hpp"

namespace castaway::testbed {

/// A row of events.csv.
struct LoggedEvent {
  RunEvent event;
  std::optional<double> time_s{};      ///< [s] For a recovery: time since the kidnap or the start.
  std::optional<double> distance_m{};  ///< [m] For a recovery: distance driven meanwhile.
};

/// Collects the events of the run, alarms and recoveries, sorted by time and in this order at equal
/// times. `metrics`: of each localizer of `history`.
std::vector<LoggedEvent> log_events(const RunHistory& history,
                                    const std::vector<LocalizerMetrics>& metrics);

}  // namespace castaway::testbed
