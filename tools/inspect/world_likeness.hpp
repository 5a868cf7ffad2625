/// Where a robot can stand in a world, and how alike these places look.
#pragma once

#include "sim/map/ambiguity.hpp"
#include "tools/sources/build_world.hpp"

namespace castaway::testbed {

inline constexpr double kPlaceRadius = 0.25;  ///< [m] Of the disc that looks for places.

/// The map with all that a low robot could run into.
sim::Grid obstacle_grid(const LoadedWorld& world);

/// Where it stands on the floor itself.
sim::FreeSpace place_space(const LoadedWorld& world);

/// Seconds for a building; the same world and view give the same figures.
sim::PlaceLikeness world_likeness(const LoadedWorld& world, const sim::PlaceView& view);

}  // namespace castaway::testbed
