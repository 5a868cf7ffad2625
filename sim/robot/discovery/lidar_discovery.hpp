/// Finds the lidars of a URDF robot. Internal to sim/robot.
#pragma once

#include <vector>

#include "sim/robot/urdf/urdf_parts.hpp"

namespace castaway::sim {

/// Finds all lidars: links (or child links of joints) with a sensor tag of type ray, gpu_ray, lidar
/// or gpu_lidar that has at least 20 beams over at least 0.3 rad (with fewer it is a range finder).
/// Without such a tag, it is the link farthest from the root whose name contains scan, laser,
/// lidar, lds or a manufacturer's name and no word for a mount. Planar lidars come first.
std::vector<LidarMount> find_lidars(const UrdfFile& file, const LinkFrames& frames);

}  // namespace castaway::sim
