/// Which keys of a campaign matter.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/batch/campaign/cell_row.hpp"
#include "tools/run/metrics/statistics/factor_effects.hpp"
#include "tools/scenario/campaign_yaml.hpp"

namespace castaway::testbed {

/// The effect of each key on a metric.
struct MetricRank {
  std::string metric;
  std::size_t seeds = 0;              ///< That every combination has the metric for.
  std::vector<std::string> factors;   ///< The keys, then "seed".
  std::vector<FactorEffect> effects;  ///< Of each; empty if the metric does not vary.
};

/// The metrics that are ranked unless others are asked for: the success of recovery and the error
/// of the position of every localizer in the rows.
std::vector<std::string> ranked_metrics(CellRows& rows);

/// Throws std::runtime_error if the campaign varies nothing that can be ranked, or both grid and
/// draws.
void require_rankable(const CampaignSpec& spec);

/// Ranks the keys of the grid by analysis of variance, or with the design `kSaltelli` those that
/// are drawn by Sobol indices. Seeds that are void, failed or without the metric in any combination
/// are left out. Throws as `require_rankable`.
MetricRank rank_keys(const CampaignSpec& spec, CellRows& rows, const std::string& metric);

/// For a terminal, largest total effect first.
std::string rank_text(const MetricRank& rank);

/// ranks.csv: metric, key, first, first_low, first_high, total, total_low, total_high, seeds.
void write_ranks(const std::vector<MetricRank>& ranks, const std::filesystem::path& file);

}  // namespace castaway::testbed
