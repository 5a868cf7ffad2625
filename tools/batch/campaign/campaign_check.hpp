/// Checks a campaign before anything is made.
#pragma once

#include <string>
#include <vector>

#include "tools/batch/campaign/campaign_request.hpp"
#include "tools/batch/jobs/job_folder.hpp"

namespace castaway::testbed {

/// A campaign whose combinations have all been read.
struct CheckedCampaign {
  CampaignSpec spec;
  std::vector<std::string> localizers;  ///< Of all cells.
  std::string data;                     ///< As in JobIdentity.
};

/// Reads the first cell of every combination, and checks the metrics that the campaign stops or is
/// ranked by, so that errors are found before anything is made. Throws std::exception naming the
/// place.
CheckedCampaign check_campaign(const CampaignRequest& request);

/// What its folder is bound to.
JobIdentity identity_of(const CheckedCampaign& campaign);

}  // namespace castaway::testbed
