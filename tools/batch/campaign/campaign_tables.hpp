/// The tables of a campaign.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "tools/batch/campaign/cell_row.hpp"
#include "tools/scenario/campaign_yaml.hpp"

namespace castaway::testbed {

/// Names of the metrics that any row has, sorted.
std::vector<std::string> metric_names(CellRows& rows);

/// results.csv: a row for each cell, in order: cell, name, seed, a column for each key that varies,
/// state, reason, then every metric of its summary. Precondition: `rows` has every cell.
void write_results(const CampaignSpec& spec, CellRows& rows, const std::filesystem::path& file);

/// kidnaps.csv: a row for each kidnap and localizer: cell, seed, the keys that vary, localizer,
/// kind, at_s, to_x_m, to_y_m, to_yaw_rad, scored, recovered, time_s.
void write_kidnaps(const CampaignSpec& spec, CellRows& rows, const std::filesystem::path& file);

/// costs.csv: cell, cpu_s, wall_s, memory_mb. It differs in every repetition.
void write_costs(CellRows& rows, const std::filesystem::path& file);

/// summary.json: for each combination of the grid the number of cells that are done, void and
/// failed, for each localizer the pooled recoveries, and of each metric n, mean, standard deviation
/// and the interval of the mean.
nlohmann::ordered_json campaign_summary(const CampaignSpec& spec, CellRows& rows);

/// The summary for a terminal: a line for each combination and localizer.
std::string campaign_text(const nlohmann::ordered_json& summary);

}  // namespace castaway::testbed
