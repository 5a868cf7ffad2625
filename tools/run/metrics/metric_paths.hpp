/// Metrics by name: the numbers of a run's summary.json and timing.json as one flat table.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace castaway::testbed {

/// Metrics by path; nothing if there was nothing to measure.
using MetricTable = std::map<std::string, std::optional<double>>;

/// Flattens a summary. The path of a metric is its keys joined by dots, with spaces as underscores:
/// "distance_m", "driving.emergency_stop". "localizers" is dropped from the paths of localizers:
/// "mh_amcl.recovery.success". Paths from `timing` (null: none) begin with "timing.". Lists and
/// texts are skipped.
MetricTable metric_table(const nlohmann::ordered_json& summary,
                         const nlohmann::ordered_json& timing = nullptr);

/// All metrics that a run with these localizers can have.
std::vector<std::string> known_metrics(const std::vector<std::string>& localizers);

}  // namespace castaway::testbed
