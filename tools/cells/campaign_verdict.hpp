/// Checks the expectations of a campaign.
#pragma once

#include <vector>

#include "tools/cells/campaign_check.hpp"
#include "tools/cells/rows/rows_file.hpp"
#include "tools/metrics/verdict.hpp"

namespace castaway::testbed {

/// Judges each expectation over the cells that have its metric. Void and failed ones are left out,
/// and so are cells without the localizer of an expectation. Where no cell is left, there is
/// nothing to measure, and the expectation is not met.
std::vector<Check> judge_cells(const CheckedCampaign& campaign, RowIndex& rows);

}  // namespace castaway::testbed
