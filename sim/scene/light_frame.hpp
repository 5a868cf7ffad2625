/// Where the sun stands, and what of a scene its shadow map covers.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "sim/scene/scene.hpp"

namespace castaway::sim {

/// Towards the sun, in map, unit: from above left of a viewer in the south.
Eigen::Vector3f to_sun();

/// A parallel view from the sun.
struct LightFrame {
  Eigen::Matrix4f clip_from_map = Eigen::Matrix4f::Identity();
  float texel_m = 0.01F;  ///< [m] Longer side of a cell of the map.
};

/// The view for a square map of `texels` a side: all of `bounds`, but no further from the ground
/// before the camera than twice the way to its target, or 8 m. It moves with the camera by whole
/// cells, so that edges of shadows stand still in a film. What is nearer to the sun than the view
/// begins must be clamped to it.
LightFrame light_frame(const Camera& camera, const Eigen::AlignedBox3f& bounds, int texels);

}  // namespace castaway::sim
