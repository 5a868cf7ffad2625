/// Tells the ground of a 3-D map from what stands on it.
#pragma once

#include "localization/space/map3d/elevation_map.hpp"
#include "localization/space/map3d/voxel_map.hpp"

namespace castaway::localization {

/// The voxels without the drivable ground: without those that may face up and are at most 1.5
/// voxels above or below a drivable surface within two cells. What remains is what a level beam may
/// not pass through; rolling ground is grazed by beams from a right pose, too. Linear in the
/// voxels.
VoxelMap without_ground(const VoxelMap& voxels, const ElevationMap& ground);

}  // namespace castaway::localization
