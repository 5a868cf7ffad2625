/// Page of an experiment: the paper's table and figures with the results of this run.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tools/batch/compare/experiment_summary.hpp"
#include "tools/batch/compare/experiment_table.hpp"

namespace castaway::testbed {

/// Input of the page.
struct ExperimentPage {
  Experiment experiment;
  TextTable table;
  nlohmann::ordered_json summary;
  std::vector<PooledRows> rows;
  std::size_t example = 0;  ///< Index of the run shown in the curves over time.
  std::string command;      ///< Command that reproduces the page.
};

/// Index of the run with the slowest recovery of any localizer, which shows best how quality and
/// uncertainty behave meanwhile. 0 if there was no recovery.
std::size_t example_run(const std::vector<ExperimentOutcome>& outcomes);

/// One self-contained HTML page.
std::string render_experiment(const ExperimentPage& page);

/// A table as HTML.
std::string html_table(const TextTable& table);

}  // namespace castaway::testbed
