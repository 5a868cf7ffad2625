/// A page that leads to the pages of several runs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace castaway::testbed {

/// Writes the page: a row a run and localizer with its words and its main figures, each run linked
/// to its report.html by a path relative to the page. Throws std::runtime_error naming the file of
/// a run that cannot be read.
void write_runs_page(const std::vector<std::filesystem::path>& folders,
                     const std::filesystem::path& page);

}  // namespace castaway::testbed
