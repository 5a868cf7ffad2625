/// How localizers fared while a sensor was at fault.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/metrics/run_rows.hpp"

namespace castaway::testbed {

/// When a fault lasted.
struct FaultWindow {
  std::string fault;  ///< Its kind, and the lidar's name if it was one of several.
  Stamp begin{};
  Stamp end{};  ///< At most the end of the run; of a reset its begin.
};

/// The faults among the events "fault on" and "fault off" of a run that ended at `end`.
std::vector<FaultWindow> fault_windows(const std::vector<RunEvent>& events, Stamp end);

/// One localizer during a fault and 5 s after it; nothing where no row was scored.
struct FaultMetrics {
  std::optional<double> mean_error_m;           ///< Position error of rows with an estimate.
  std::optional<double> wrong_confident_share;  ///< Of those, the ones that are wrong (0.5 m or
                                                ///< 0.35 rad and more) without an alarm.
  bool alarm = false;                           ///< It raised the alarm at some time.
};

/// Rows count by the time when their answer was there.
FaultMetrics measure_fault(const std::vector<MetricRow>& rows, const FaultWindow& window);

}  // namespace castaway::testbed
