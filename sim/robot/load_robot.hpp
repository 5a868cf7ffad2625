/// A robot from a URDF file.
#pragma once

#include <string>
#include <vector>

#include "sim/robot/robot_model.hpp"

namespace castaway::sim {

/// Loads a plain URDF file (xacro only as far as it names constants).
///
/// Mesh URIs (`package://`, `model://`, `file://`, relative) are looked up in the packages among
/// the file's ancestors and their siblings, then in `search_paths`. What can be repaired (inertia,
/// missing meshes, missing casters) is repaired and told in `RobotModel::warnings`.
/// @throws std::runtime_error naming the file, what is wrong and what to do.
RobotModel load_robot(const std::string& path, const std::vector<std::string>& search_paths = {});

}  // namespace castaway::sim
