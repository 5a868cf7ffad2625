/// The page of a campaign.
#pragma once

#include <string>

#include "tools/pages/campaign/figures/campaign_figures.hpp"
#include "tools/pages/campaign/heat_section.hpp"

namespace castaway::testbed {

/// One self-contained HTML page. The same rows give the same bytes.
std::string render_campaign_page(const FinishedCampaign& campaign, const CampaignFigures& figures,
                                 MapOfWorld map_of_world);

}  // namespace castaway::testbed
