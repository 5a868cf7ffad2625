/// The SDF elements that are read. Internal to sim/world/sdf: it exposes libsdformat's types.
#pragma once

#include <sdf/sdf.hh>

namespace castaway::sim {

/// Returns an empty tree for libsdformat to read into. It contains the elements of SDF except
/// unneeded ones (see `is_unneeded`): libsdformat copies for each model everything that a model
/// could contain, which takes most of its time and memory.
sdf::SDFPtr empty_sdf();

}  // namespace castaway::sim
