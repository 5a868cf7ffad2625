/// Rays through a 3-D map: whether something is in their way.
#pragma once

#include <Eigen/Core>

#include "localization/map3d/voxel_distances.hpp"

namespace castaway::localization {

/// True if the straight way from `from` to `to` [m] passes through a surface: nearer to one than
/// half a voxel's edge. Surfaces at which the ray begins do not count, until it has left them.
///
/// Sphere tracing: J. C. Hart, "Sphere tracing: a geometric method for the antialiased ray tracing
/// of implicit surfaces", The Visual Computer 12 (1996).
bool meets_surface(const VoxelDistances& distances, const Eigen::Vector3f& from,
                   const Eigen::Vector3f& to);

}  // namespace castaway::localization
