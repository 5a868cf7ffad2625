/// Lidars in YAML: in scenarios and device profiles.
#pragma once

#include <vector>

#include "sim/sensor/lidar_config.hpp"
#include "tools/scenario/sections/scenario.hpp"
#include "tools/scenario/yaml/settings.hpp"

namespace castaway::testbed {

/// Settings of a lidar that a scenario can change.
void fields(Settings settings, sim::LidarConfig& lidar);

/// Reads and checks the lidar settings of a map and returns them as written. Other keys are
/// ignored.
YamlNode read_lidar_changes(YamlReader& map);

/// Reads the lidars of a scenario: those under `lidars` (names of the robot's own lidars, or names
/// with profile and settings), or else all lidars of the robot with the changes under `lidar`.
std::vector<LidarSpec> read_lidars(YamlReader& root);

/// Applies changes (`read_lidar_changes`) to a lidar. Throws as reading them does.
sim::LidarConfig apply_changes(sim::LidarConfig lidar, const YamlNode& changes);

}  // namespace castaway::testbed
