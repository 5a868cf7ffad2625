/// Finds the lidars of a URDF robot. Internal to sim/robot.
#pragma once

#include <vector>

#include "sim/robot/urdf/urdf_parts.hpp"

namespace castaway::sim {

/// All lidars: links (or child links of joints) with a sensor tag of type ray, gpu_ray, lidar or
/// gpu_lidar that has at least 20 beams over at least 0.3 rad (fewer make a range finder). Where no
/// tag is, the links whose names hold scan, laser, lidar, lds or a maker's name and that are no
/// mounts, the one farthest from the root. Planar ones first.
std::vector<LidarMount> find_lidars(const UrdfFile& file, const LinkFrames& frames);

}  // namespace castaway::sim
