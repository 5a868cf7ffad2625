/// castaway's own file of a 3-D map: voxels with their surface points, and the ground.
#pragma once

#include <string>
#include <string_view>

#include "localization/space/map3d/elevation_map.hpp"
#include "localization/space/map3d/voxel_map.hpp"

namespace castaway::testbed {

/// A 3-D map with the ground that was surveyed in it.
struct Map3d {
  localization::VoxelMap voxels;
  localization::ElevationMap ground;
};

/// First line of the file.
inline constexpr std::string_view kMap3dHead = "castaway-map3d 1\n";

/// Throws std::runtime_error if the map is larger than `decode_map3d` takes: 10 million voxels or
/// surfaces of the ground, 25 million cells of the ground.
///
/// The file: a line of text, then zstd. The same map gives the same bytes for a version of zstd.
std::string encode_map3d(const Map3d& map);

/// Reads a file. `name` is used in errors. Throws std::runtime_error of one line for what is no
/// such file, is damaged, or holds more than 512 MiB.
Map3d decode_map3d(std::string_view bytes, const std::string& name);

}  // namespace castaway::testbed
