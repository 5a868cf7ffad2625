/// What the runs of an experiment amount to.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tools/campaign/error_rows.hpp"
#include "tools/campaign/paper_experiments.hpp"

namespace castaway::testbed {

/// A finished run of an experiment.
struct ExperimentOutcome {
  ExperimentRun run;
  std::filesystem::path folder;    ///< Where it is.
  nlohmann::ordered_json summary;  ///< Its summary.json...
  nlohmann::ordered_json timing;   ///< ...and timing.json; null in what is byte-identical.
};

/// Rows of all runs of one localizer, run after run.
struct PooledRows {
  std::string localizer;
  std::vector<std::vector<ErrorRow>> runs;
};

/// Reads all runs' errors.csv.
std::vector<PooledRows> pooled_rows(const std::vector<ExperimentOutcome>& outcomes);

/// summary.json of an experiment. For each localizer: `error_m` over all scans with an answer
/// (mean, sd, median; `mean_interval`: bootstrap over the runs' means), `hypotheses`, `quality`,
/// `sigma_m`, pooled `recovery`, `discrimination` (areas under the ROC curve over all scans) and
/// `correlation` of quality and sigma with the error. Of an experiment that is driven by an
/// estimate: `driving`.
nlohmann::ordered_json summarise(const Experiment& experiment,
                                 const std::vector<ExperimentOutcome>& outcomes,
                                 const std::vector<PooledRows>& rows);

/// timing.json of an experiment: for each localizer the CPU time of an update, mean over the runs'
/// means and the largest; wall time of all runs together.
nlohmann::ordered_json timing_of(const std::vector<ExperimentOutcome>& outcomes);

}  // namespace castaway::testbed
