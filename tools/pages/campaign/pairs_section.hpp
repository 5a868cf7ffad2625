/// Differences of localizers in the same cells, as a table.
#pragma once

#include <string>

#include "tools/pages/campaign/figures/campaign_figures.hpp"

namespace castaway::testbed {

/// The tests of all pairs, as HTML; a sentence if there are none.
std::string pairs_section(const CampaignFigures& figures);

}  // namespace castaway::testbed
