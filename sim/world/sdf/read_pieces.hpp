/// Reads the pieces of an SDF world by libsdformat. Internal to sim/world/sdf: it exposes
/// libsdformat's types.
#pragma once

#include <string>

#include <sdf/sdf.hh>

#include "sim/world/sdf/sdf_bodies.hpp"
#include "sim/world/sdf/world_pieces.hpp"

namespace castaway::sim {

/// Returns an empty tree for libsdformat to read into. It contains the elements of SDF except
/// unneeded ones (see `is_unneeded`): libsdformat copies for each model everything that a model
/// could contain, which takes most of its time and memory.
sdf::SDFPtr empty_sdf();

/// Reads the pieces in batches, since libsdformat needs megabytes per model, and adds them to
/// `bodies`. A batch that cannot be read is halved until the faulty piece is found, which is left
/// out. `path`: of the world, for errors.
/// @throws std::runtime_error naming file, piece and reason.
void read_pieces(const WorldPieces& world, const std::string& path, const ResourceFinder& finder,
                 const PiecePolicy& policy, SdfBodies& bodies);

}  // namespace castaway::sim
