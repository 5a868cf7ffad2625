/// Makes campaigns on a Slurm cluster.
#pragma once

#include "tools/batch/campaign/campaign_request.hpp"
#include "tools/batch/cluster/slurm_job.hpp"

namespace castaway::testbed {

/// Submits the campaign as an array of shards with a collecting job behind it, then follows it as
/// `follow_on_slurm` does. `out` must be on a file system that all nodes share. Throws
/// std::runtime_error if jobs of this campaign are in the queue already, or Slurm refuses them.
int make_on_slurm(const CampaignRequest& request, const SlurmOptions& options);

/// Follows the submitted jobs of a campaign with a progress line until its tables are made. Shards
/// that ended with cells missing are submitted again, twice at most. The jobs go on if this process
/// ends. Returns as `collect_campaign`. Throws std::runtime_error if nothing was submitted.
int follow_on_slurm(const CampaignRequest& request);

}  // namespace castaway::testbed
