/// A world from a map: its walls, pulled up.
#pragma once

#include <string>

#include "sim/map/grid.hpp"
#include "sim/world/world_spec.hpp"

namespace castaway::sim {

/// The world in which every occupied cell of `grid` is solid from the floor to `wall_height` [m].
/// Cells are merged greedily into boxes: runs along a row first, then equal runs of the rows above.
/// The boxes are in the map; their union is exactly the occupied cells. Linear in the cells.
WorldSpec extrude(const Grid& grid, double wall_height, const std::string& name);

}  // namespace castaway::sim
