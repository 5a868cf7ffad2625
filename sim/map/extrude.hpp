/// Extrudes the walls of a map into a world.
#pragma once

#include <string>

#include "sim/map/grid.hpp"
#include "sim/world/world.hpp"

namespace castaway::sim {

/// Returns the world in which every occupied cell of `grid` is solid from the floor to
/// `wall_height` [m]. Cells are merged greedily into boxes: runs along a row first, then equal runs
/// of the rows above. The union of the boxes, in map, is exactly the occupied cells. Linear in the
/// number of cells.
WorldSpec extrude(const Grid& grid, double wall_height, const std::string& name);

}  // namespace castaway::sim
