/// The elements of SDF that are read. Internal to sim/world/sdf: it shows libsdformat's types.
#pragma once

#include <sdf/sdf.hh>

namespace castaway::sim {

/// An empty tree for libsdformat to read into. It knows the elements of SDF but those that are
/// unneeded (see `is_unneeded`): libsdformat copies all that a model could contain for each model,
/// which takes most of its time and memory.
sdf::SDFPtr empty_sdf();

}  // namespace castaway::sim
