/// Projections of a camera.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "sim/scene/scene.hpp"

namespace castaway::sim {

/// Eye coordinates of a point in map: x right, y up, z backward. [m]
Eigen::Matrix4f eye_from_map(const Camera& camera);

/// Clip coordinates of a point in map, as in OpenGL: x right, y up, z forward, each in [-w, w].
/// `aspect` is width / height. Visible from 0.05 m to 200 m, or to three times the distance of the
/// target if that is more.
Eigen::Matrix4f clip_from_map(const Camera& camera, float aspect);

/// Moves the camera away from its target until a box is completely visible; unchanged if it already
/// is. Perspective cameras only.
Camera step_back(Camera camera, const Eigen::AlignedBox3f& box, float aspect);

/// The eye's position (x, y, z, 1) or, for a parallel projection, the direction towards the viewer
/// (x, y, z, 0).
Eigen::Vector4f viewpoint(const Camera& camera);

}  // namespace castaway::sim
