/// Loads a robot from a URDF or xacro file.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "sim/robot/urdf/robot_model.hpp"
#include "xacro/options.hpp"

namespace castaway::sim {

/// Options besides the file. `read_yaml` also reads the parameters of drive controllers; without it
/// they are ignored.
struct RobotOptions : xacro::Options {
  std::vector<std::string> search_paths;  ///< Folders to search for packages.
  std::map<std::string, double> joints;   ///< Joint positions, [rad] or [m]; other joints are at 0.
};

/// Loads a URDF file; xacro in it is expanded (see `xacro::expand`).
///
/// Packages and meshes are looked up as in `PackageFinder`, the search paths of the environment
/// last. Problems that can be repaired (inertia, missing meshes, missing casters, ...) are repaired
/// and reported in `RobotModel::warnings`. A skid steer is turned in place to measure its effective
/// track.
/// @throws std::runtime_error naming the file, what is wrong and what to do.
RobotModel load_robot(const std::string& path, const RobotOptions& options = {});

/// The URDF that results from expanding a xacro file.
struct ExpandedRobot {
  std::string urdf;
  std::vector<std::string> warnings;
};

/// Only expands a file. @throws std::runtime_error as `load_robot`.
ExpandedRobot expand_robot(const std::string& path, const RobotOptions& options = {});

}  // namespace castaway::sim
