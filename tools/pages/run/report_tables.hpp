/// Tables of a report.
#pragma once

#include <string>

#include "tools/pages/run/run_folder.hpp"

namespace castaway::testbed {

/// Metrics from summary.json, one column per localizer.
std::string metric_table(const RunFolder& run);

/// Events of the robot and each localizer's recoveries, sorted by time.
std::string event_table(const RunFolder& run);

/// CPU times from timing.json.
std::string timing_tables(const RunFolder& run);

}  // namespace castaway::testbed
