/// Coarser levels of a map (paper, section IV-A).
#pragma once

#include "localization/map/occupancy_grid.hpp"

namespace castaway::localization {

/// The map with cells `factor` times as large: occupied if any of the covered cells is, else free
/// if any is, else unknown. Cells at the upper and right border may extend beyond the map.
OccupancyGrid coarsen(const OccupancyGrid& grid, int factor);

}  // namespace castaway::localization
