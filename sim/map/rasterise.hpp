/// Rasterises a world into a map.
#pragma once

#include <vector>

#include "sim/map/grid.hpp"
#include "sim/world/world.hpp"

namespace castaway::sim {

/// Rasterises a world's extent as a perfect survey at height `z` [m] would. Cells that an object on
/// the map touches are occupied. Free is the open area that contains `WorldSpec::inside`, or else
/// the one that `choose_free` chooses; all other cells are unknown. `resolution` [m].
/// @throws std::invalid_argument if the world has no extent, std::runtime_error if a mesh cannot be
/// read.
Grid rasterise(const WorldSpec& world, double z, double resolution);

/// The same with all open areas free.
Grid cut_world(const WorldSpec& world, double z, double resolution);

/// Marks the cells of `grid` occupied that any object of the world (on the map or not) covers at
/// one of the heights [m]. Drivable objects are skipped.
void mark_objects(Grid& grid, const WorldSpec& world, const std::vector<double>& heights);

}  // namespace castaway::sim
