/// Rays through a 3-D map: what is in their way.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "localization/space/volume/surface_field.hpp"
#include "localization/space/volume/voxel_distances.hpp"

namespace castaway::localization {

/// What a ray meets on its way.
enum class Encounter {
  kNone,
  kReached,  ///< It comes to a surface, and is still there at its end.
  kPassed,   ///< It comes to a surface and leaves it again.
};

/// The straight way from one point to another. [m]
struct Ray {
  Eigen::Vector3f from = Eigen::Vector3f::Zero();
  Eigen::Vector3f to = Eigen::Vector3f::Zero();
};

/// What each ray meets: a ray is at a surface where it is nearer than three quarters of a voxel's
/// edge, so that no wall is missed wherever in its voxels it is. Surfaces at which a ray begins do
/// not count, until it has left them.
///
/// Sphere tracing: J. C. Hart, "Sphere tracing: a geometric method for the antialiased ray tracing
/// of implicit surfaces", The Visual Computer 12 (1996).
std::vector<Encounter> encounters(const VoxelDistances& distances, std::span<const Ray> rays);
std::vector<Encounter> encounters(const SurfaceField& surfaces, std::span<const Ray> rays);

/// Indices of the rays that pass through a surface, if the rays a voxel's edge beside them do, too,
/// on all four sides: a beam from a right pose may graze an edge. On a rough map, on three sides:
/// its walls have holes, and its edges are not known so well.
std::vector<std::size_t> passing_through(const VoxelDistances& distances,
                                         std::span<const Ray> rays);

}  // namespace castaway::localization
