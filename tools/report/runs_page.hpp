/// Index page of several runs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace castaway::testbed {

/// One row for each run and localizer with a summary and the main metrics. Each run is linked to
/// its report.html by a path relative to `page`. Throws std::runtime_error naming the file of a run
/// that cannot be read.
std::string render_runs_page(const std::vector<std::filesystem::path>& folders,
                             const std::filesystem::path& page);

/// Writes it.
void write_runs_page(const std::vector<std::filesystem::path>& folders,
                     const std::filesystem::path& page);

}  // namespace castaway::testbed
