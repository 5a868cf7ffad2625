/// Lidars in YAML: in scenarios and in the files of devices.
#pragma once

#include <vector>

#include "sim/sensor/lidar_config.hpp"
#include "tools/scenario/sections/scenario.hpp"
#include "tools/scenario/yaml/settings.hpp"

namespace castaway::testbed {

/// What a scenario can change about a lidar.
void fields(Settings settings, sim::LidarConfig& lidar);

/// The settings of a lidar in this map, checked, as they are written. Other keys are left alone.
YamlNode read_lidar_changes(YamlReader& map);

/// The lidars of a scenario: those under `lidars` (names of the robot's own, or names with their
/// profile and settings), else what `lidar` changes about all that the robot has.
std::vector<LidarSpec> read_lidars(YamlReader& root);

/// A lidar with changes (`read_lidar_changes`). Throws as reading them does.
sim::LidarConfig changed(sim::LidarConfig lidar, const YamlNode& changes);

}  // namespace castaway::testbed
