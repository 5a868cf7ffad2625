/// Pieces of the surfaces of a 3-D map, one in each occupied voxel: of planes, of lines (poles,
/// edges), or points.
///
/// They are cells of a normal distributions transform: P. Biber, W. Strasser, "The Normal
/// Distributions Transform: A New Approach to Laser Scan Matching", IROS 2003. The shape is taken
/// from the distribution of the mean surface points of a voxel and those around it.
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "localization/space/map3d/voxel_map.hpp"

namespace castaway::localization {

enum class PatchShape : std::uint8_t { kPlane, kLine, kPoint };

/// The surface about the mean surface point of a voxel.
struct SurfacePatch {
  /// Of length 1: normal of a plane, direction of a line. Zero for a point.
  Eigen::Vector3f axis = Eigen::Vector3f::Zero();
  PatchShape shape = PatchShape::kPoint;
};

/// One for each voxel, in their order.
std::vector<SurfacePatch> surface_patches(const VoxelMap& map);

/// The shortest way from a patch to a point at `p` from its mean surface point, in edges of a
/// voxel. A patch ends 0.75 edges from that point.
Eigen::Vector3f way_from(const SurfacePatch& patch, const Eigen::Vector3f& p);

}  // namespace castaway::localization
