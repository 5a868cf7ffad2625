/// Finds the driven wheels of a URDF robot. Internal to sim/robot.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "sim/robot/discovery/drive_tags.hpp"
#include "sim/robot/discovery/wheel_shape.hpp"

namespace castaway::sim {

/// The drive joints in the order left, right, left, right, ..., the front pair first, and how they
/// were found.
struct DriveJoints {
  std::vector<std::string> joints;
  std::string found_by;  ///< The dialect of the tags, or "kinematics".
};

/// Finds the joints that the tags name, at any place in the tree, if they turn about y and form
/// pairs. Without tags, or if theirs form no pair (a warning): continuous joints that hang on the
/// chassis, or else on a suspension, turn about y, lie left and right of each other, reach the
/// floor and are not named casters.
/// @throws std::runtime_error if there is no pair.
DriveJoints find_drive_joints(const UrdfFile& file, const LinkFrames& frames,
                              const MeshFinder& finder, const DriveTags& tags,
                              std::vector<std::string>& warnings);

}  // namespace castaway::sim
