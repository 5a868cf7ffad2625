/// Distance along a ray to the first wall of a map, exact for square cells.
///
/// J. Amanatides, A. Woo, "A Fast Voxel Traversal Algorithm for Ray Tracing", Eurographics 1987.
#pragma once

#include "localization/map/occupancy_grid.hpp"

namespace castaway::localization {

/// Distance from `from_cells` (a point in the grid's frame, in cells) along `direction` (a unit
/// vector in that frame) to the first cell that is not free; unknown cells and cells off the map
/// are not free. 0 if the ray starts in such a cell, `longest` if there is none within that
/// distance. [cells]
double cast_ray(const OccupancyGrid& grid, const Eigen::Vector2d& from_cells,
                const Eigen::Vector2d& direction, double longest);

}  // namespace castaway::localization
