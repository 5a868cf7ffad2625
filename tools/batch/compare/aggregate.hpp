/// Statistics over several runs of one scenario.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "tools/run/metrics/metric_paths.hpp"

namespace castaway::testbed {

/// Aggregates every figure over runs: mean, median, p95, min, max and the bootstrap interval of the
/// mean (`mean_interval`, resampling single runs). `runs` is the number of runs that have the
/// figure.
nlohmann::ordered_json aggregate_figures(const std::vector<MetricTable>& runs);

/// Pools the recoveries of all localizers of the runs into one sample: events, recovered, success
/// with its Wilson interval, and statistics of times and distances with bootstrap intervals.
/// `summaries`: summary.json of each run.
nlohmann::ordered_json pooled_recoveries(const std::vector<nlohmann::ordered_json>& summaries);

}  // namespace castaway::testbed
