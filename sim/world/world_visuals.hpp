/// Visual shapes of a world, for rendering.
#pragma once

#include <vector>

#include "sim/scene/scene.hpp"
#include "sim/world/world.hpp"

namespace castaway::sim {

/// The surface of a shape in its frame. @throws std::runtime_error if a mesh cannot be read.
TriangleMesh shape_mesh(const ObjectShape& shape);

/// One item per object in a world, in their order and colours; the floor is not included. Roofs are
/// items of their own and cast no shadow (`split_roofs`). An item's instance is
/// `kFirstObjectInstance` + index of the object. A mesh's material colours are multiplied with the
/// object's colour.
/// @throws std::runtime_error if a mesh cannot be read.
std::vector<SceneItem> world_visuals(const WorldSpec& world);

/// The same without roofs, for a view from above.
std::vector<SceneItem> world_visuals_from_above(const WorldSpec& world);

}  // namespace castaway::sim
