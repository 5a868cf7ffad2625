/// When a combination of a campaign has enough cells.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tools/batch/campaign/cell_row.hpp"
#include "tools/scenario/campaign_yaml.hpp"

namespace castaway::testbed {

/// How many of a combination's cells, from its first one on, its rows ask for: all that the
/// specification has, or with `until` those up to the first look at which the interval is narrow
/// enough, or up to the look that comes next. It follows from the rows alone, so that a campaign
/// ends alike however it was stopped or shared.
int cells_needed(const CampaignSpec& spec, CellRows& rows, int combination);

/// Cells that are needed and have no row, in order; at most `most`.
std::vector<int> missing_cells(const CampaignSpec& spec, CellRows& rows, std::size_t most);

/// True if a metric is a share of 1: a success, an availability.
bool is_share(const std::string& metric);

}  // namespace castaway::testbed
