/// Finds the driven wheels of a URDF robot. Internal to sim/robot.
#pragma once

#include <string>
#include <vector>

#include "sim/robot/urdf_parts.hpp"

namespace castaway::sim {

/// Joints of the driven wheels: pairs of continuous joints that hang on the chassis and turn about
/// y, mirrored left and right. A plug-in tag that names wheel joints decides where there are
/// several pairs. Left, right, left, right...
/// @throws std::runtime_error if there is no pair.
std::vector<std::string> find_drive_joints(const UrdfFile& file, const LinkFrames& frames);

/// Radius of a wheel, from the collision shape of its link, else from the visual one. [m]
/// @throws std::runtime_error if it has neither.
double wheel_radius(const UrdfFile& file, const urdf::Link& link, const LinkFrames& frames,
                    const MeshFinder& finder);

}  // namespace castaway::sim
