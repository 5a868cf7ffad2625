/// A map from a world: its cut at the lidar's height.
#pragma once

#include <vector>

#include "sim/map/grid.hpp"
#include "sim/world/world_spec.hpp"

namespace castaway::sim {

/// The map of a world's extent as a perfect survey at height `z` [m] gives it: occupied where an
/// object that is on the map is cut (also in part), free where the open area is that holds
/// `WorldSpec::inside`, or else the one that `choose_free` takes, unknown elsewhere. `resolution`
/// [m].
/// @throws std::invalid_argument if the world has no extent, std::runtime_error if a mesh cannot be
/// read.
Grid rasterise(const WorldSpec& world, double z, double resolution);

/// The same with all open areas free.
Grid cut_world(const WorldSpec& world, double z, double resolution);

/// Makes the cells of `grid` occupied that any object of the world (on the map or not) covers at
/// one of the heights [m]. What is meant to be driven over is left out.
void mark_objects(Grid& grid, const WorldSpec& world, const std::vector<double>& heights);

}  // namespace castaway::sim
