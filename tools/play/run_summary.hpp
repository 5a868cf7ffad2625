/// A finished run as text, from its files.
#pragma once

#include <filesystem>
#include <string>

namespace castaway::testbed {

/// Text for a terminal: one line a localizer, the cost, where the report is. Reads summary.json and
/// timing.json.
std::string describe_run(const std::filesystem::path& run_folder);

}  // namespace castaway::testbed
