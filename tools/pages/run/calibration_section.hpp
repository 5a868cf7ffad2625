/// Calibration of the stated probabilities in a report.
#pragma once

#include <string>

#include "tools/pages/run/run_folder.hpp"

namespace castaway::testbed {

/// Diagram and table of every localizer's calibration, as HTML; empty if the summary has none.
std::string calibration_html(const RunFolder& run);

}  // namespace castaway::testbed
