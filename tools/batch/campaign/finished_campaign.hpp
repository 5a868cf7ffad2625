/// A campaign whose cells are all there.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "tools/batch/campaign/cell_row.hpp"
#include "tools/run/metrics/verdict.hpp"
#include "tools/scenario/campaign_yaml.hpp"

namespace castaway::testbed {

/// What pages of a campaign are made from.
struct FinishedCampaign {
  const CampaignSpec& spec;
  const std::vector<std::string>& overrides;   ///< Of the scenario, as key=value.
  const std::vector<std::string>& localizers;  ///< Of all cells.
  const std::vector<Check>& checks;            ///< Of the expectations.
  std::filesystem::path folder;
  CellRows& rows;
};

/// Files beside the tables: names and contents.
using CampaignPages = std::vector<std::pair<std::string, std::string>>;
using RenderCampaignPages = CampaignPages (*)(const FinishedCampaign&);

}  // namespace castaway::testbed
