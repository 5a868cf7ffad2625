/// The boxes around things of a scene.
#pragma once

#include <Eigen/Geometry>

#include "sim/scene/scene.hpp"

namespace castaway::sim {

/// In map, along its axes; wider than need be for a turned item. Empty if the mesh is.
Eigen::AlignedBox3f bounds_of(const SceneItem& item);

/// Around all that light falls on. Empty if nothing is lit.
Eigen::AlignedBox3f lit_bounds(const Scene& scene);

/// Height of what casts shadows; roofs and floors do not. 0 if nothing does. [m]
float standing_height(const std::vector<SceneItem>& items);

}  // namespace castaway::sim
