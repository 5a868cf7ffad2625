/// The pieces of an SDF world through libsdformat.
#pragma once

#include <string>

#include "sim/world/sdf/sdf_bodies.hpp"
#include "sim/world/sdf/world_pieces.hpp"

namespace castaway::sim {

/// Reads the pieces, some at a time, since libsdformat needs megabytes for a model, and adds them
/// to `bodies`. Where it cannot read some, it tries halves of them, down to the piece that is at
/// fault, which is left out. `path`: of the world, for errors.
/// @throws std::runtime_error naming file, piece and reason.
void read_pieces(const WorldPieces& world, const std::string& path, const ResourceFinder& finder,
                 const PiecePolicy& policy, SdfBodies& bodies);

}  // namespace castaway::sim
