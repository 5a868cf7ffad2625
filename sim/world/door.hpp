/// Leaves of doors.
#pragma once

#include <Eigen/Geometry>

#include "sim/world/world.hpp"

namespace castaway::sim {

/// Returns the leaf of a door that is open by `open_deg`: a box without a colour of its own.
WorldObject door_leaf(const Door& door, double open_deg);

/// Opens or closes a door of a world: its leaf in the world turns, and the one on the map stays.
/// @throws std::invalid_argument if the world has no such door.
void set_door(WorldSpec& world, const std::string& name, double open_deg);

}  // namespace castaway::sim
