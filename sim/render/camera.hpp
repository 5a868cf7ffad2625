/// Where things of a scene appear on the picture.
#pragma once

#include <Eigen/Core>

#include "sim/render/scene.hpp"

namespace castaway::sim {

/// Clip coordinates of a point in map: OpenGL's, x right, y up, z forward, each in [-w, w].
/// `aspect` is width / height. Visible from 0.05 m to 200 m before the eye.
Eigen::Matrix4f clip_from_map(const Camera& camera, float aspect);

/// The point towards which a surface at `p_map` is seen, as (x, y, z, 1), or the direction, as
/// (x, y, z, 0), for a parallel projection.
Eigen::Vector4f viewpoint(const Camera& camera);

}  // namespace castaway::sim
