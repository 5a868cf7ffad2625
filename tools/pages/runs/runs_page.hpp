/// Page of several runs: what they amount to, and a table that leads to their reports.
#pragma once

#include <string>

#include "tools/play/shown_runs.hpp"

namespace castaway::testbed {

/// The pooled figures of each localizer with their intervals and verdicts, a chart of the
/// recoveries, and a row for each run. The same runs give the same bytes. Throws std::runtime_error
/// naming the file of a run that cannot be read.
std::string render_runs_page(const ShownRuns& page);

}  // namespace castaway::testbed
