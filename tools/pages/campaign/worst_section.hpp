/// The worst kidnaps, each with what plays it again.
#pragma once

#include <string>

#include "tools/pages/campaign/figures/campaign_figures.hpp"

namespace castaway::testbed {

/// The command that plays a cell again in full. The specification is named without its folder, so
/// that the page does not depend on where it is.
std::string replay_command(const FinishedCampaign& campaign, int cell);

/// The table, as HTML, with links to reports of cells that were kept.
std::string worst_section(const FinishedCampaign& campaign, const CampaignFigures& figures);

}  // namespace castaway::testbed
