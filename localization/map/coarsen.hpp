/// The levels of resolution of a map (paper, section IV-A).
#pragma once

#include "localization/map/occupancy_grid.hpp"

namespace castaway::localization {

/// The map with cells `factor` times as large: occupied where any of them is, else free where any
/// is, else unknown. Cells at the upper and right border may stand over.
OccupancyGrid coarsened(const OccupancyGrid& grid, int factor);

}  // namespace castaway::localization
