/// The cells of a campaign: one run each.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tools/scenario/campaign_yaml.hpp"
#include "tools/scenario/scenario_file.hpp"

namespace castaway::testbed {

/// A run of a campaign.
struct CampaignCell {
  int index = 0;     ///< Seeds vary fastest, then the last key of the grid.
  std::string name;  ///< 16 hex digits that follow from its scenario: equal cells, equal names.
  std::uint64_t seed = 1;
  /// Keys that vary, with their values as YAML on one line: the grid's, then those drawn.
  std::vector<std::pair<std::string, std::string>> values;
  LoadedScenario loaded;
};

/// A value as it is in `CampaignCell::values`.
std::string value_text(const YamlNode& value);

/// The values of a combination of the grid, as in `CampaignCell::values`.
std::vector<std::pair<std::string, std::string>> combination_values(const CampaignSpec& spec,
                                                                    int combination);

/// The seed of a cell's run.
std::uint64_t cell_seed(const CampaignSpec& spec, int index);

/// Makes a cell. Drawn values depend on the sample alone, unless the design is `kSaltelli` on the
/// seed alone: cells of other combinations have the same ones. Throws std::runtime_error naming the
/// cell and the place if its scenario is invalid.
CampaignCell campaign_cell(const CampaignSpec& spec, int index);

}  // namespace castaway::testbed
