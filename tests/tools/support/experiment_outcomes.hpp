/// Finished runs of an experiment for tests, with made-up values.
#pragma once

#include <nlohmann/json.hpp>

#include "tools/batch/compare/experiment_summary.hpp"
#include "tools/run/metrics/metrics_json.hpp"

namespace castaway::testbed {

/// A run of the first part in which localizer `a` recovered after `time_s`.
inline ExperimentOutcome outcome_with(const Experiment& experiment, std::uint64_t seed,
                                      double time_s) {
  nlohmann::ordered_json summary{{"distance_m", 10.0}, {"duration_s", 3600.0}, {"collisions", 1}};
  summary["driving"] = {{"recoveries", 2}, {"emergency stop", 3}};
  auto& localizer = summary["localizers"]["a"];
  localizer = to_json(LocalizerMetrics{});
  localizer["recovery"]["events"] = 1;
  localizer["recovery"]["time_s"]["max"] = time_s;
  localizer["recovery"]["each"] = {{{"recovered", true}, {"time_s", time_s}, {"distance_m", 0.5}}};
  ExperimentOutcome outcome;
  outcome.run = {experiment.parts.at(0).name, "x.yaml", {}, seed, "runs/x"};
  outcome.summary = summary;
  outcome.timing = {{"wall_s", 2.0},
                    {"localizers", {{"a", {{"update_ms", {{"mean", 0.5}, {"max", 4.0}}}}}}}};
  return outcome;
}

/// Two runs of two scans each: one right with quality 0.9, one wrong with quality 0.3.
inline std::vector<PooledRows> two_runs_of_rows() {
  const ErrorRow right{1.0, 0.1, 0.9, 0.01, 0.8, 1.0};
  const ErrorRow wrong{2.0, 4.1, 0.3, 0.01, 0.8, 3.0};
  return {{"a", {{right, wrong}, {right, wrong}}}};
}

}  // namespace castaway::testbed
