/// Metrics of localizers during sensor faults.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/run/metrics/run_rows.hpp"

namespace castaway::testbed {

/// Time interval of a fault.
struct FaultWindow {
  sim::FaultEdge::What fault;
  Stamp begin{};
  Stamp end{};  ///< At most the end of the run. For a reset, equal to `begin`.
};

/// Extracts the faults from the "fault on" and "fault off" events of a run that ended at `end`.
std::vector<FaultWindow> fault_windows(const std::vector<RunEvent>& events, Stamp end);

/// Metrics of one localizer during a fault and the 5 s after it; nothing if no row was scored.
struct FaultMetrics {
  std::optional<double> mean_error_m;           ///< Mean position error of the rows with an
                                                ///< estimate.
  std::optional<double> wrong_confident_share;  ///< Share of those rows that are wrong (at least
                                                ///< 0.5 m or 0.35 rad) without the alarm.
  bool alarm = false;                           ///< The alarm was raised at some time.
};

/// Measures a fault. Rows are selected by the time of their answer.
FaultMetrics measure_fault(const std::vector<MetricRow>& rows, const FaultWindow& window);

}  // namespace castaway::testbed
