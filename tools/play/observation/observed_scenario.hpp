/// The scenario of an observation, from what a user calls it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/scenario/scenario_file.hpp"

namespace castaway::testbed {

/// A scenario and the folder that its relative paths start from.
struct ObservedScenario {
  LoadedScenario loaded;
  std::filesystem::path base;
};

/// Loads a scenario (a file, or "<world>/<name>"), or makes one for a world: a shipped one's name,
/// a folder with a world.yaml, an SDF file. In a world the robot is `waffle` with a lidar of 12 m,
/// or on several floors and slopes `mule` with one of 16 layers. `overrides`: key=value, as for
/// --set. Throws as `load_scenario` and `load_world` do.
ObservedScenario observed_scenario(const std::string& text,
                                   const std::vector<std::string>& overrides);

}  // namespace castaway::testbed
