/// Several runs of one scenario put together.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "tools/metrics/metric_paths.hpp"

namespace castaway::testbed {

/// Every figure over runs: mean, median, p95, min, max and the bootstrap interval of the mean
/// (`mean_interval`, runs drawn one by one), with `runs`: how many had something to measure.
nlohmann::ordered_json aggregate_figures(const std::vector<MetricTable>& runs);

/// Recoveries of all runs' localizers as one sample: events, recovered, success with its Wilson
/// interval, statistics of the times and ways with bootstrap intervals. `summaries`: of the runs.
nlohmann::ordered_json pooled_recoveries(const std::vector<nlohmann::ordered_json>& summaries);

}  // namespace castaway::testbed
