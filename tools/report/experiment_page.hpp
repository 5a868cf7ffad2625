/// The page of an experiment: the paper's table and figures, made from this run.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tools/campaign/experiment_summary.hpp"
#include "tools/campaign/experiment_table.hpp"

namespace castaway::testbed {

/// What the page is made of.
struct ExperimentPage {
  Experiment experiment;
  TextTable table;
  nlohmann::ordered_json summary;
  std::vector<PooledRows> rows;
  std::size_t example = 0;  ///< Index of the run that the curves over time show.
  std::string command;      ///< That makes the page anew.
};

/// Index of the run in which some localizer took longest to recover; 0 where there was nothing to
/// recover from. It shows best what quality and uncertainty do meanwhile.
std::size_t example_run(const std::vector<ExperimentOutcome>& outcomes);

/// One self-contained HTML page.
std::string render_experiment(const ExperimentPage& page);

/// A table as HTML.
std::string html_table(const TextTable& table);

}  // namespace castaway::testbed
