/// Finds the lidar of a URDF robot. Internal to sim/robot.
#pragma once

#include <optional>

#include "sim/robot/urdf_parts.hpp"

namespace castaway::sim {

/// The first link with a sensor tag of type ray, gpu_ray, lidar or gpu_lidar; else the first whose
/// name holds scan, laser, lidar or lds; nothing if there is none.
std::optional<LidarMount> find_lidar(const UrdfFile& file, const LinkFrames& frames);

}  // namespace castaway::sim
