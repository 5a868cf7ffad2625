/// Makes campaigns.
#pragma once

#include "tools/batch/campaign/campaign_request.hpp"
#include "tools/batch/cluster/slurm_batch.hpp"

namespace castaway::testbed {

/// Makes the missing cells of the campaign in the batch's folder and, unless other shards make the
/// rest, its tables. Returns kDone; kRunFailed if a cell failed; kExpectationNotMet if an
/// expectation was not met. Throws std::exception before anything is made if the specification is
/// invalid or the folder holds something else; Interrupted after a signal, and the same call goes
/// on.
int make_campaign(const CampaignRequest& request);

/// Makes the tables of a campaign whose shards are done. Returns as `make_campaign`; names the
/// cells that are missing and returns kRunFailed if there are any.
int collect_campaign(const CampaignRequest& request);

/// Makes a campaign on a cluster, as `follow_on_cluster` does. Returns as `collect_campaign`.
int make_campaign_on_slurm(const CampaignRequest& request, const ClusterRequest& cluster);

/// Plays one cell again, in full, as the run folder `out`. Returns as `play`.
int make_cell(const CampaignRequest& request, int index);

}  // namespace castaway::testbed
