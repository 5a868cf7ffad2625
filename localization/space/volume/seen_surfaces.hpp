/// The surfaces of a 3-D map that can be seen from its ground.
#pragma once

#include "localization/space/map3d/elevation_map.hpp"
#include "localization/space/map3d/voxel_map.hpp"

namespace castaway::localization {

/// The voxels next to free space that is connected with the space above drivable ground. What lies
/// behind walls is left out: the outer face of a wall would explain a scan taken a wall's
/// thickness farther on. A map that covers more than 2^31 voxels of space is returned as it is.
VoxelMap seen_surfaces(const VoxelMap& voxels, const ElevationMap& ground);

}  // namespace castaway::localization
