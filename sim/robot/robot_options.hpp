/// Options of reading a robot's description.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "xacro/options.hpp"

namespace castaway::sim {

/// Options besides the file. `read_yaml` also reads the parameters of drive controllers; without it
/// they are ignored.
struct RobotOptions : xacro::Options {
  std::vector<std::string> search_paths;  ///< Folders to search for packages.
  std::map<std::string, double> joints;   ///< Joint positions, [rad] or [m]; other joints are at 0.
};

}  // namespace castaway::sim
