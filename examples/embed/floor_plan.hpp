/// The building that this example's robot drives in.
#pragma once

#include <Eigen/Core>

#include <castaway/grid.hpp>

/// The map as the localizer takes it: cells of 0.05 m, origin at the lower left corner.
castaway::OccupancyGrid floor_plan();

/// Distance from a point to the first wall in a direction; `longest` if there is none nearer. [m]
double distance_to_wall(const castaway::OccupancyGrid& plan, const Eigen::Vector2d& p_map,
                        double direction, double longest);
