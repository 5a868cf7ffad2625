/// Makes the cells of a campaign in worker processes.
#pragma once

#include <vector>

#include "tools/batch/campaign/campaign_request.hpp"

namespace castaway::testbed {

/// Makes cells as `make_rows` does. A cell that fails has a row, too.
void make_cells(const CampaignRequest& request, const CampaignSpec& spec,
                const std::vector<int>& cells);

}  // namespace castaway::testbed
