/// What the runs of a set amount to: a table with a row for each localizer.
#pragma once

#include <string>

#include "tools/pages/runs/run_set.hpp"

namespace castaway::testbed {

/// Recoveries pooled over all kidnaps, means over the runs, 95 % intervals below them, and how the
/// localizers compare. The figures are those of the set's summary.json. A sentence without
/// localizers.
std::string pooled_table(const RunSet& set);

}  // namespace castaway::testbed
