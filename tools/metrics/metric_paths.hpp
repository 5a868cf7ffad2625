/// Metrics by name: the figures of a run's summary.json and timing.json as one flat table.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace castaway::testbed {

/// Figures by path; nothing where there was nothing to measure.
using MetricTable = std::map<std::string, std::optional<double>>;

/// Every figure of a summary by its keys, joined by dots, with spaces as underscores:
/// "distance_m", "driving.emergency_stop"; a localizer's without "localizers":
/// "mh_amcl.recovery.success". Those of `timing` (null: none) begin with "timing.". Lists and texts
/// are left out.
MetricTable metric_table(const nlohmann::ordered_json& summary,
                         const nlohmann::ordered_json& timing = nullptr);

/// The metrics that a run with these localizers can have.
std::vector<std::string> known_metrics(const std::vector<std::string>& localizers);

}  // namespace castaway::testbed
