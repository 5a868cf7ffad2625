/// Index page of several runs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace castaway::testbed {

/// Writes the page: one row for each run and localizer with a summary and the main metrics. Each
/// run is linked to its report.html by a relative path. Throws std::runtime_error naming the file
/// of a run that cannot be read.
void write_runs_page(const std::vector<std::filesystem::path>& folders,
                     const std::filesystem::path& page);

}  // namespace castaway::testbed
