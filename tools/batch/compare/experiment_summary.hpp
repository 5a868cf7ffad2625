/// Summary of the runs of an experiment.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tools/batch/compare/error_rows.hpp"
#include "tools/batch/compare/paper_experiments.hpp"

namespace castaway::testbed {

/// A finished run of an experiment.
struct ExperimentOutcome {
  ExperimentRun run;
  std::filesystem::path folder;
  nlohmann::ordered_json summary;  ///< summary.json of the run.
  nlohmann::ordered_json timing;   ///< timing.json of the run; null if the output must be
                                   ///< byte-identical.
};

/// Rows of one localizer, by run.
struct PooledRows {
  std::string localizer;
  std::vector<std::vector<ErrorRow>> runs;
};

/// Reads errors.csv of all runs.
std::vector<PooledRows> pooled_rows(const std::vector<ExperimentOutcome>& outcomes);

/// Builds summary.json of an experiment. For each localizer: `error_m` over all scans with an
/// output (mean, sd, median; `mean_interval` is the bootstrap interval over the runs' means),
/// `hypotheses`, `quality`, `sigma_m`, pooled `recovery`, `discrimination` (areas under the ROC
/// curve over all scans) and `correlation` of quality and sigma with the error. An experiment in
/// which an estimate drives the robot also has `driving`.
nlohmann::ordered_json summarise(const Experiment& experiment,
                                 const std::vector<ExperimentOutcome>& outcomes,
                                 const std::vector<PooledRows>& rows);

/// Builds timing.json of an experiment: for each localizer the CPU time of an update (mean of the
/// runs' means, and maximum), and the wall time of all runs together.
nlohmann::ordered_json timing_of(const std::vector<ExperimentOutcome>& outcomes);

}  // namespace castaway::testbed
