/// How near the cells of a stack are to obstacles.
#pragma once

#include <cstdint>
#include <vector>

#include "localization/space/map3d/voxel_map.hpp"
#include "localization/space/stack/stack_frame.hpp"

namespace castaway::localization {

/// For each cell of a stack, row by row: `255 exp(-d^2 / 2 sigma^2)` of the least distance d [m]
/// from the cell to an obstacle; 0 farther than three sigma. Ground is no obstacle: all places see
/// it alike. The underside of a floor is no obstacle on it.
std::vector<std::uint8_t> stack_obstacles(const VoxelMap& voxels, const ElevationMap& ground,
                                          const StackFrame& stack, double sigma);

}  // namespace castaway::localization
