/// Reads the pieces of an SDF world by libsdformat.
#pragma once

#include <string>

#include "sim/world/sdf/sdf_bodies.hpp"
#include "sim/world/sdf/world_pieces.hpp"

namespace castaway::sim {

/// Reads the pieces in batches, since libsdformat needs megabytes per model, and adds them to
/// `bodies`. A batch that cannot be read is halved until the faulty piece is found, which is left
/// out. `path`: of the world, for errors.
/// @throws std::runtime_error naming file, piece and reason.
void read_pieces(const WorldPieces& world, const std::string& path, const ResourceFinder& finder,
                 const PiecePolicy& policy, SdfBodies& bodies);

}  // namespace castaway::sim
