/// How far a world in the open goes.
#pragma once

#include <optional>
#include <string>

#include "sim/map/grid.hpp"
#include "sim/world/floor.hpp"
#include "sim/world/world_spec.hpp"

namespace castaway::sim {

/// Extends a world over its ground: over all of a plane of up to 100 m x 100 m, over what lies
/// within 50 m of its extent of a larger one, and over 15 m around where the plane has no end.
/// Returns a line where that is less than the plane.
std::optional<std::string> extend_over(const Ground& ground, WorldSpec& world);

/// Makes free cells unknown that lie further than 5 m from every obstacle: on a wide plain a robot
/// there has nothing to localize by. The grid as it is if nothing stands in it.
Grid near_obstacles(Grid grid);

}  // namespace castaway::sim
