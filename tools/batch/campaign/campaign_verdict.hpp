/// Checks the expectations of a campaign.
#pragma once

#include <vector>

#include "tools/batch/campaign/campaign_check.hpp"
#include "tools/batch/campaign/cell_row.hpp"
#include "tools/run/metrics/verdict.hpp"

namespace castaway::testbed {

/// Judges each expectation over the cells that have its metric. Void and failed ones are left out,
/// and so are cells without the localizer of an expectation. Where no cell is left, there is
/// nothing to measure, and the expectation is not met.
std::vector<Check> judge_cells(const CheckedCampaign& campaign, CellRows& rows);

}  // namespace castaway::testbed
