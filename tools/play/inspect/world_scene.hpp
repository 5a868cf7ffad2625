/// A loaded world as scenes.
#pragma once

#include "sim/scene/scene.hpp"
#include "tools/build/build_world.hpp"

namespace castaway::testbed {

/// Shows the world from above its southern edge: routes in blue, slip zones in orange, the start as
/// an arrow. Throws std::runtime_error if a mesh cannot be read.
sim::Scene world_scene(const LoadedWorld& world);

/// Shows the map from straight above, with the same marks.
sim::Scene world_map_scene(const LoadedWorld& world);

}  // namespace castaway::testbed
