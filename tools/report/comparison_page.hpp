/// The page of a comparison, and its table.
#pragma once

#include <string>
#include <vector>

#include "tools/campaign/comparison.hpp"
#include "tools/campaign/experiment_table.hpp"

namespace castaway::testbed {

/// A row for each metric: means, difference with its interval, better or worse.
TextTable comparison_table(const Comparison& comparison);

/// One self-contained HTML page: for each comparison the table and a picture of the differences
/// relative to the baseline.
std::string render_comparison(const std::vector<Comparison>& comparisons);

}  // namespace castaway::testbed
