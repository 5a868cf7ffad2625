/// Solid obstacles reduced to the surfaces that a lidar can see.
#pragma once

#include "localization/map/occupancy_grid.hpp"

namespace castaway::localization {

/// The map with the inside of obstacles unknown: occupied cells that are more than `depth` [m],
/// and more than one cell, from every cell of the map that is not occupied. No beam ends there, but
/// on a map drawn with solid obstacles a whole scan would fit inside of one.
OccupancyGrid hollow(const OccupancyGrid& grid, double depth);

}  // namespace castaway::localization
