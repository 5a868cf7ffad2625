/// What was understood of a world, as scenes.
#pragma once

#include "sim/scene/scene.hpp"
#include "tools/sources/build_world.hpp"

namespace castaway::testbed {

/// The world from above its southern edge; routes in blue, slip zones in orange, the start as an
/// arrow. @throws std::runtime_error if a mesh cannot be read.
sim::Scene world_scene(const LoadedWorld& world);

/// The map from straight above, with the same marks.
sim::Scene world_map_scene(const LoadedWorld& world);

}  // namespace castaway::testbed
