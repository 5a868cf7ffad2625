/// The curves of a run that left no recording, and the legend of its map.
#pragma once

#include <string>

#include "tools/report/run_folder.hpp"

namespace castaway::testbed {

/// Lines of the truth and of each localizer, as the map draws them.
std::string map_legend(const RunFolder& run);

/// Position error, yaw error and quality over time. Empty if the build has no script to draw them.
std::string curves_section(const RunFolder& run);

}  // namespace castaway::testbed
