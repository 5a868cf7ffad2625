/// Planar maps cut out of 3-D maps.
#pragma once

#include <string>

#include "tools/base/formats/ros_map.hpp"
#include "tools/base/formats/volume/map3d_file.hpp"

namespace castaway::testbed {

/// The cross-section of a 3-D map at a height [m] in map, for planar localizers: occupied where a
/// voxel holds a surface, free where drivable ground is up to 2 m below, unknown elsewhere. Its
/// cells are as large as the voxels. Throws std::runtime_error if no surface is at that height.
RosMap map_slice(const Map3d& map, double height, const std::string& name);

}  // namespace castaway::testbed
