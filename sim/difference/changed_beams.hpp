/// Measures how much a world differs from its map for a lidar.
#pragma once

#include "sim/map/grid.hpp"
#include "sim/map/places.hpp"
#include "sim/world/world.hpp"

namespace castaway::sim {

/// The share of beams that end elsewhere in the world than on the map.
struct BeamChange {
  double share = 0.0;  ///< Of beams whose length differs by more than 0.2 m: the difference number.
  double share_fine = 0.0;  ///< Of beams whose length differs by more than 0.1 m.
  int places = 0;           ///< Number of places from which beams were cast.
};

/// Casts beams from places half a metre apart (at most 4000, so farther apart on large maps) that
/// are free on the map and in the world for a disc of 0.2 m, and compares the ranges in the
/// surveyed world with those in the current world. Glass counts as a wall. @throws
/// std::runtime_error if a mesh cannot be read.
BeamChange changed_beams(const WorldSpec& world, const Grid& map, const PlaceView& view);

}  // namespace castaway::sim
