/// Rays through a 3-D map: what is in their way.
#pragma once

#include <Eigen/Core>

#include "localization/volume/surface_field.hpp"
#include "localization/volume/voxel_distances.hpp"

namespace castaway::localization {

/// What a ray meets on its way.
enum class Encounter {
  kNone,
  kReached,  ///< It comes to a surface, and is still there at its end.
  kPassed,   ///< It comes to a surface and leaves it again.
};

/// What the straight way from `from` to `to` [m] meets: a ray is at a surface where it is nearer
/// than three quarters of a voxel's edge, so that no wall is missed wherever in its voxels it is.
/// Surfaces at which the ray begins do not count, until it has left them.
///
/// Sphere tracing: J. C. Hart, "Sphere tracing: a geometric method for the antialiased ray tracing
/// of implicit surfaces", The Visual Computer 12 (1996).
Encounter encounter(const VoxelDistances& distances, const Eigen::Vector3f& from,
                    const Eigen::Vector3f& to);
Encounter encounter(const SurfaceField& surfaces, const Eigen::Vector3f& from,
                    const Eigen::Vector3f& to);

/// True if the straight way from `from` to `to` [m] passes through a surface, and the ways a
/// voxel's edge beside it do, too, on all four sides: a beam from a right pose may graze an edge.
/// On a rough map, on three sides: its walls have holes, and its edges are not known so well.
bool passes_through(const VoxelDistances& distances, const Eigen::Vector3f& from,
                    const Eigen::Vector3f& to);

}  // namespace castaway::localization
