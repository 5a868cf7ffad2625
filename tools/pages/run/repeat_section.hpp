/// Section of a report: what was run, how to repeat it, and what was expected of it.
#pragma once

#include <string>

#include "tools/pages/run/run_folder.hpp"

namespace castaway::testbed {

/// Version, command and settings; empty if the folder has no scenario.yaml.
std::string repeat_section(const RunFolder& run);

/// Every expectation of the run's settings with the value that the run has; empty if there is none.
/// Those about times are left out: they differ from one repetition to the next.
std::string expectations_section(const RunFolder& run);

}  // namespace castaway::testbed
