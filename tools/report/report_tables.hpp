/// Tables of a report.
#pragma once

#include <string>

#include "tools/report/run_folder.hpp"

namespace castaway::testbed {

/// The figures of summary.json, a column a localizer.
std::string metric_table(const RunFolder& run);

/// What happened to the robot and each localizer's recoveries, by time.
std::string event_table(const RunFolder& run);

/// The figures of timing.json.
std::string timing_tables(const RunFolder& run);

}  // namespace castaway::testbed
