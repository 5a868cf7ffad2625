/// The way to the first wall of a map along a ray, exact for square cells.
///
/// J. Amanatides, A. Woo, "A Fast Voxel Traversal Algorithm for Ray Tracing", Eurographics 1987.
#pragma once

#include "localization/map/occupancy_grid.hpp"

namespace castaway::localization {

/// Distance from `from_cells` (a point of the grid's frame, in cells) along `direction` (a unit
/// vector of that frame) to the first cell that is not free; unknown cells and what lies off the
/// map are not free. 0 from within such a cell, `longest` if there is none so near. [cells]
double cast_ray(const OccupancyGrid& grid, const Eigen::Vector2d& from_cells,
                const Eigen::Vector2d& direction, double longest);

}  // namespace castaway::localization
