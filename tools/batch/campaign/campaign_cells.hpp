/// Makes the cells of a campaign in worker processes.
#pragma once

#include <vector>

#include "tools/batch/campaign/campaign_request.hpp"

namespace castaway::testbed {

/// Makes cells, each in one of `request.workers` processes, and adds their rows to the shard's file
/// in `request.out` as they end. A cell that fails has a row, too. Throws FileError if a row cannot
/// be written; Interrupted after a signal.
void make_cells(const CampaignRequest& request, const CampaignSpec& spec,
                const std::vector<int>& cells);

}  // namespace castaway::testbed
