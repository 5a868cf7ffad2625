/// Direction of the sun, and the part of a scene that its shadow map covers.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "sim/scene/scene.hpp"

namespace castaway::sim {

/// Unit vector towards the sun, in map: from above left for a viewer in the south.
Eigen::Vector3f to_sun();

/// A parallel projection from the sun.
struct LightFrame {
  Eigen::Matrix4f clip_from_map = Eigen::Matrix4f::Identity();
  float texel_m = 0.01F;  ///< [m] Longer side of a cell of the shadow map.
};

/// The projection for a square shadow map of `texels` per side: all of `bounds`, but not farther
/// from the ground ahead of the camera than twice the distance to its target, or 8 m. It moves with
/// the camera by whole cells, so that edges of shadows do not flicker in a film. Surfaces nearer to
/// the sun than the near plane must be clamped to it.
LightFrame light_frame(const Camera& camera, const Eigen::AlignedBox3f& bounds, int texels);

}  // namespace castaway::sim
