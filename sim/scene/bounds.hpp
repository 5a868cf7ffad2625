/// Bounding boxes of a scene's items.
#pragma once

#include <Eigen/Geometry>

#include "sim/scene/scene.hpp"

namespace castaway::sim {

/// Axis-aligned in map, not tight for a rotated item. Empty if the mesh is.
Eigen::AlignedBox3f bounds_of(const SceneItem& item);

/// Bounds of all shaded items. Empty if there are none.
Eigen::AlignedBox3f lit_bounds(const Scene& scene);

/// Height of the highest item that casts a shadow (not a roof or floor); 0 without any. [m]
float standing_height(const std::vector<SceneItem>& items);

}  // namespace castaway::sim
