/// What a robot's description is read with.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "sim/xacro/value.hpp"

namespace castaway::sim {

/// Beside the file.
struct RobotOptions {
  std::map<std::string, std::string> arguments;  ///< Of xacro, before their defaults.
  std::vector<std::string> search_paths;         ///< Folders that packages are looked for in.
  std::map<std::string, double> joints;  ///< Positions of joints, [rad] or [m]; others are at 0.
  /// Reads a YAML file for `xacro.load_yaml` and for the parameters of drive controllers; throws
  /// std::runtime_error. Empty: the first is an error, the second is left out.
  std::function<xacro::Value(const std::string& path)> read_yaml;
};

}  // namespace castaway::sim
