/// Creates driven wheels from their joints. Internal to sim/robot.
#pragma once

#include <string>
#include <vector>

#include "sim/robot/discovery/wheel_discovery.hpp"

namespace castaway::sim {

/// Returns the wheels on the drive joints, in their order, in the root link's frame, without
/// masses. A tag's radius is used if there is no shape or only a rough one; if it contradicts a
/// shape, the shape's radius is used, with a warning. @throws std::runtime_error if neither gives a
/// radius.
std::vector<DriveWheel> mount_wheels(const UrdfFile& file, const LinkFrames& frames,
                                     const MeshFinder& finder, const DriveTags& tags,
                                     const DriveJoints& drive, std::vector<std::string>& warnings);

}  // namespace castaway::sim
