/// Places where a robot can stand in a world, and how similar they look.
#pragma once

#include "sim/map/ambiguity.hpp"
#include "tools/build/build_world.hpp"

namespace castaway::testbed {

inline constexpr double kPlaceRadius = 0.25;  ///< [m] Radius of the disc that must fit at a place.

/// The map with all obstacles that a low robot could hit.
sim::Grid obstacle_grid(const LoadedWorld& world);

/// Free space on the floor.
sim::FreeSpace place_space(const LoadedWorld& world);

/// Deterministic for a world and a view; takes seconds for a building.
sim::PlaceLikeness world_likeness(const LoadedWorld& world, const sim::PlaceView& view);

}  // namespace castaway::testbed
