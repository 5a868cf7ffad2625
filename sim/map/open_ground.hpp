/// The extent of an outdoor world.
#pragma once

#include <optional>
#include <string>

#include "sim/map/grid.hpp"
#include "sim/world/floor.hpp"
#include "sim/world/world.hpp"

namespace castaway::sim {

/// Extends a world over its ground: over all of a plane of up to 100 m x 100 m, over 50 m around
/// the world's extent on a larger plane, and over 15 m around it on an infinite one. Returns a
/// message if that is less than the plane.
std::optional<std::string> extend_over(const Ground& ground, WorldSpec& world);

/// Makes free cells unknown that are more than 5 m from every obstacle: on a wide plain a robot
/// there has nothing to localize by. Returns the grid unchanged if it has no obstacles.
Grid near_obstacles(Grid grid);

}  // namespace castaway::sim
