/// A robot from a URDF or xacro file.
#pragma once

#include <string>
#include <vector>

#include "sim/robot/urdf/robot_model.hpp"
#include "sim/xacro/robot_options.hpp"

namespace castaway::sim {

/// Loads a URDF file; what xacro it holds is expanded (see `xacro::expand`).
///
/// Packages and meshes are looked up as `PackageFinder` says, the search paths of the environment
/// last. What can be repaired (inertia, missing meshes, missing casters...) is repaired and told in
/// `RobotModel::warnings`. A skid steer is turned on the spot for its effective track.
/// @throws std::runtime_error naming the file, what is wrong and what to do.
RobotModel load_robot(const std::string& path, const RobotOptions& options = {});

/// The URDF that a xacro file expands to.
struct ExpandedRobot {
  std::string urdf;
  std::vector<std::string> warnings;
};

/// Expands a file and does nothing else. @throws std::runtime_error as `load_robot`.
ExpandedRobot expand_robot(const std::string& path, const RobotOptions& options = {});

}  // namespace castaway::sim
