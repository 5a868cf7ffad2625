/// Driven wheels from their joints. Internal to sim/robot.
#pragma once

#include <string>
#include <vector>

#include "sim/robot/discovery/wheel_discovery.hpp"

namespace castaway::sim {

/// The wheels on the drive joints, in their order, in the root link; masses are left out. A tag's
/// radius stands where there is no shape or a rough one; where it contradicts a shape, that rolls,
/// with a warning. @throws std::runtime_error if neither gives a radius.
std::vector<DriveWheel> mount_wheels(const UrdfFile& file, const LinkFrames& frames,
                                     const MeshFinder& finder, const DriveTags& tags,
                                     const DriveJoints& drive, std::vector<std::string>& warnings);

}  // namespace castaway::sim
