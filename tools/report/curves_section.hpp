/// Curves of a run without a recording, and the legend of its map.
#pragma once

#include <string>

#include "tools/report/run_folder.hpp"

namespace castaway::testbed {

/// Legend with the line styles of the truth and of each localizer.
std::string map_legend(const RunFolder& run);

/// Plots of position error, yaw error and quality over time. Empty if the build has no script to
/// draw them.
std::string curves_section(const RunFolder& run);

}  // namespace castaway::testbed
