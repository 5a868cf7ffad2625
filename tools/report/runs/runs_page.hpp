/// Page of several runs: what they amount to, and a table that leads to their reports.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "tools/metrics/verdict.hpp"

namespace castaway::testbed {

/// What the page shows.
struct RunsPage {
  std::vector<std::filesystem::path> folders;  ///< Of the runs, with summary.json.
  std::filesystem::path page;                  ///< Reports are linked by paths relative to it.
  std::vector<std::uint64_t> failed_seeds{};   ///< Their runs left no summary.
  std::vector<Check> checks{};                 ///< Of expectations; those of clocks are not shown.
};

/// The pooled figures of each localizer with their intervals and verdicts, a chart of the
/// recoveries, and a row for each run. The same runs give the same bytes. Throws std::runtime_error
/// naming the file of a run that cannot be read.
std::string render_runs_page(const RunsPage& page);

/// Writes it to `page.page`.
void write_runs_page(const RunsPage& page);

}  // namespace castaway::testbed
