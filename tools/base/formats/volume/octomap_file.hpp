/// OctoMap files: `.bt` (occupied or free) and `.ot` (probabilities).
///
/// A. Hornung, K. M. Wurm, M. Bennewitz, C. Stachniss, W. Burgard, "OctoMap: An efficient
/// probabilistic 3D mapping framework based on octrees", Autonomous Robots 34 (2013). Read and
/// written with liboctomap. Free space is not kept: a map here knows surfaces.
#pragma once

#include <string>
#include <string_view>

#include "localization/space/map3d/voxel_map.hpp"
#include "tools/base/formats/volume/octomap_check.hpp"

namespace castaway::testbed {

/// The file of a map. Its tree has the map's voxels as leaves. Throws std::invalid_argument for a
/// map that reaches farther than 32768 voxels from the origin.
std::string encode_octomap(const localization::VoxelMap& map, OctomapKind kind);

/// The occupied voxels of a file of either kind, with their centres as surface points. `name` is
/// used in errors. Throws std::runtime_error of one line for what is no such file.
localization::VoxelMap decode_octomap(std::string_view bytes, const std::string& name);

}  // namespace castaway::testbed
