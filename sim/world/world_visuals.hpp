/// What a world looks like.
#pragma once

#include <vector>

#include "sim/scene/scene.hpp"
#include "sim/world/world_spec.hpp"

namespace castaway::sim {

/// The surface of a shape, about its frame. @throws std::runtime_error if a mesh cannot be read.
TriangleMesh shape_mesh(const ObjectShape& shape);

/// One item for each object that stands in a world, in their order, in the objects' colours; the
/// floor is left out. Roofs are items of their own and cast no shadow (`part_roofs`). Their
/// instances are `kFirstObjectInstance` + index of the object. A mesh's own material colours are
/// multiplied with the object's.
/// @throws std::runtime_error if a mesh cannot be read.
std::vector<SceneItem> world_visuals(const WorldSpec& world);

/// The same for a view from above: without roofs.
std::vector<SceneItem> world_visuals_from_above(const WorldSpec& world);

}  // namespace castaway::sim
