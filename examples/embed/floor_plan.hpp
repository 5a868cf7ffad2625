/// The building that this example's robot drives in.
#pragma once

#include <Eigen/Core>

#include <localization/map/occupancy_grid.hpp>

/// The map as the localizer takes it: cells of 0.05 m, origin at the lower left corner.
castaway::localization::OccupancyGrid floor_plan();

/// Distance from a point to the first wall in a direction; `longest` if there is none nearer. [m]
double distance_to_wall(const castaway::localization::OccupancyGrid& plan,
                        const Eigen::Vector2d& p_map, double direction, double longest);
