/// What the cells of a campaign cost. Its figures differ in every repetition.
#pragma once

#include <string>

#include "tools/batch/campaign/finished_campaign.hpp"
#include "tools/pages/campaign/figures/key_axis.hpp"

namespace castaway::testbed {

/// One self-contained page: totals, curves over the keys, the most expensive cells. Reads every
/// row once.
std::string render_cost_page(const FinishedCampaign& campaign, const std::vector<KeyAxis>& axes);

}  // namespace castaway::testbed
