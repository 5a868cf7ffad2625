/// Where things of a scene appear on the picture.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "sim/scene/scene.hpp"

namespace castaway::sim {

/// Eye coordinates of a point in map: x right, y up, z backward. [m]
Eigen::Matrix4f eye_from_map(const Camera& camera);

/// Clip coordinates of a point in map: OpenGL's, x right, y up, z forward, each in [-w, w].
/// `aspect` is width / height. Visible from 0.05 m before the eye to 200 m,
/// or to three times the way to the target.
Eigen::Matrix4f clip_from_map(const Camera& camera, float aspect);

/// The camera, as far back from its target as a box needs to be seen wholly; where it is, if that
/// is enough. Perspective cameras only.
Camera step_back(Camera camera, const Eigen::AlignedBox3f& box, float aspect);

/// The point towards which a surface at `p_map` is seen, as (x, y, z, 1), or the direction, as
/// (x, y, z, 0), for a parallel projection.
Eigen::Vector4f viewpoint(const Camera& camera);

}  // namespace castaway::sim
