/// The head of a campaign's page: cells, kidnaps, expectations.
#pragma once

#include <string>

#include "tools/pages/campaign/figures/campaign_figures.hpp"

namespace castaway::testbed {

/// Heading, a line of counts, a sentence for each localizer, and the expectations, as HTML.
std::string headline_html(const FinishedCampaign& campaign, const CampaignFigures& figures);

/// Why cells are void or failed, as HTML; empty if all are done.
std::string unscored_section(const CampaignFigures& figures);

}  // namespace castaway::testbed
