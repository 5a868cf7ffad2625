/// The runs of a set as a table.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "tools/pages/html/data_table.hpp"
#include "tools/pages/runs/run_set.hpp"

namespace castaway::testbed {

/// A row for each run, with a link to its report by a path relative to `page`, and one for each
/// seed that failed. What went wrong has the class "bad": kidnaps without recovery, void and failed
/// runs.
DataTable runs_table(const RunSet& set, const std::vector<std::uint64_t>& failed_seeds,
                     const std::filesystem::path& page);

}  // namespace castaway::testbed
