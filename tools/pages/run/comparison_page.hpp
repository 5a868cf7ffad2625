/// Page and table of a comparison.
#pragma once

#include <string>
#include <vector>

#include "tools/batch/compare/comparison.hpp"
#include "tools/batch/compare/experiment_table.hpp"

namespace castaway::testbed {

/// A row per metric: means, difference with its interval, better or worse.
TextTable comparison_table(const Comparison& comparison);

/// One self-contained HTML page with, for each comparison, the table and a chart of the differences
/// relative to the baseline.
std::string render_comparison(const std::vector<Comparison>& comparisons);

}  // namespace castaway::testbed
