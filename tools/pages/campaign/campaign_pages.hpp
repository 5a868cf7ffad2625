/// All pages of a campaign.
#pragma once

#include <string>

#include "tools/batch/campaign/finished_campaign.hpp"
#include "tools/pages/campaign/figures/campaign_figures.hpp"
#include "tools/pages/campaign/heat_section.hpp"

namespace castaway::testbed {

/// One self-contained HTML page. The same rows give the same bytes.
std::string render_campaign_page(const FinishedCampaign& campaign, const CampaignFigures& figures,
                                 MapOfWorld map_of_world);

/// campaign.html, which is the same in every repetition, and costs.html, which is not.
CampaignPages render_campaign_pages(const FinishedCampaign& campaign);

}  // namespace castaway::testbed
