/// How different a world is from its map, as a lidar has it.
#pragma once

#include "sim/map/grid.hpp"
#include "sim/map/places.hpp"
#include "sim/world/world_spec.hpp"

namespace castaway::sim {

/// The difference number: the share of beams that end elsewhere in the world than on the map.
struct BeamChange {
  double share = 0.0;       ///< Of beams whose length differs by more than 0.2 m. The number.
  double share_fine = 0.0;  ///< The same by more than 0.1 m.
  int places = 0;           ///< Where beams were cast from.
};

/// Casts beams from places half a metre apart (further on large maps: at most 4000), free on the
/// map and in the world for a disc of 0.2 m, into what is on the map and into what is in the world.
/// Glass counts as a wall. @throws std::runtime_error if a mesh cannot be read.
BeamChange changed_beams(const WorldSpec& world, const Grid& map, const PlaceView& view);

}  // namespace castaway::sim
