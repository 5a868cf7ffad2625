/// Curves of a run without a recording.
#pragma once

#include <string>

#include "tools/pages/run/run_folder.hpp"

namespace castaway::testbed {

/// Plots of position error, yaw error and quality over time. Empty if the build has no script to
/// draw them.
std::string curves_section(const RunFolder& run);

}  // namespace castaway::testbed
