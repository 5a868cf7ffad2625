/// Options of reading a robot's description.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "sim/xacro/value.hpp"

namespace castaway::sim {

/// Options besides the file.
struct RobotOptions {
  /// Values of xacro arguments; they override defaults.
  std::map<std::string, std::string> arguments;
  std::vector<std::string> search_paths;  ///< Folders to search for packages.
  std::map<std::string, double> joints;   ///< Joint positions, [rad] or [m]; other joints are at 0.
  /// Reads a YAML file for `xacro.load_yaml` and for parameters of drive controllers; throws
  /// std::runtime_error. If empty, `load_yaml` is an error and the parameters are ignored.
  std::function<xacro::Value(const std::string& path)> read_yaml;
};

}  // namespace castaway::sim
