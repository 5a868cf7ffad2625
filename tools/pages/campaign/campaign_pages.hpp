/// All pages of a campaign.
#pragma once

#include "tools/batch/campaign/finished_campaign.hpp"

namespace castaway::testbed {

/// campaign.html, which is the same in every repetition, and costs.html, which is not.
CampaignPages render_campaign_pages(const FinishedCampaign& campaign);

}  // namespace castaway::testbed
