/// Curves and tables of figures over the varied keys.
#pragma once

#include <string>

#include "tools/pages/campaign/figures/campaign_figures.hpp"
#include "tools/pages/html/data_table.hpp"

namespace castaway::testbed {

/// Recoveries and tracking error over all cells and at each value of each key.
DataTable figures_table(const CampaignFigures& figures);

/// Curves of every metric over every key, and the table, as HTML.
std::string figures_section(const CampaignFigures& figures);

/// Survival curves of the time to recovery, and their table, as HTML.
std::string recovery_section(const CampaignFigures& figures);

}  // namespace castaway::testbed
