/// Finds the lidars of a URDF robot. Internal to sim/robot.
#pragma once

#include <string>
#include <vector>

#include "sim/robot/urdf/urdf_parts.hpp"

namespace castaway::sim {

/// Finds all lidars: links (or child links of joints) with a sensor tag of type ray, gpu_ray, lidar
/// or gpu_lidar that has at least 20 beams over at least 0.3 rad (with fewer it is a range finder,
/// which is left out with a warning). Without such a tag, they are the links whose names contain
/// scan, laser, lidar, lds or a manufacturer's name and no word for a mount, and that hold no other
/// such link. Planar lidars come first.
std::vector<LidarMount> find_lidars(const UrdfFile& file, const LinkFrames& frames,
                                    std::vector<std::string>& warnings);

}  // namespace castaway::sim
