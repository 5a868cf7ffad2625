/// The curves of a run as pictures that need no script.
#pragma once

#include <string>

#include "tools/report/run_folder.hpp"

namespace castaway::testbed {

/// A line a localizer, as the curves draw it, and the truth's if asked for.
std::string legend(const RunFolder& run, bool with_truth);

/// A titled part of the page.
std::string section(const std::string& title, const std::string& body);

/// Position error, yaw error and quality over time.
std::string curves_section(const RunFolder& run);

}  // namespace castaway::testbed
