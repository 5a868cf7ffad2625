/// The ground that wheels roll on: the floor and drivable objects.
#pragma once

#include <vector>

#include "sim/map/grid.hpp"
#include "sim/world/world.hpp"

namespace castaway::sim {

/// Height of the ground at the centre of each cell, [m]; 0 on the floor. Empty if no object in the
/// world is drivable. Floors above the lowest one, from 1 m on, are left out. @throws
/// std::runtime_error if a mesh cannot be read.
std::vector<float> ground_heights(const WorldSpec& world, const Grid& grid);

/// Makes cells of raised ground free, even if they are occupied on the map.
void free_raised(Grid& grid, const std::vector<float>& heights);

/// Makes the cells on both sides of a ledge occupied, where the heights of two neighbours differ by
/// more than 3 cm. Slopes up to 60 % are no ledges at 5 cm per cell.
void mark_ledges(Grid& grid, const std::vector<float>& heights);

/// Makes cells more than 1 cm above the floor occupied: a robot cannot be put down there.
void mark_raised(Grid& grid, const std::vector<float>& heights);

}  // namespace castaway::sim
