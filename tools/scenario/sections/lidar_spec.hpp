/// Lidars in YAML: in scenarios and in the files of devices.
#pragma once

#include <vector>

#include "sim/sensor/lidar_config.hpp"
#include "tools/scenario/sections/scenario.hpp"
#include "tools/scenario/yaml/yaml_reader.hpp"

namespace castaway::testbed {

/// Reads the figures of a lidar, all optional:
///
///     beams: 360               # a layer
///     angle_min_deg: -180      # of the first beam; without it the field of view lies ahead
///     fov_deg: 360             # from the first beam to the last; a full circle has no last one
///     range_min: 0.12          # m
///     range_max: 3.5           # m
///     rate_hz: 5               # turns a second
///     sweep: true              # each beam at its own time
///     elevations_deg: [-1, 1]  # of the layers of a 3-D lidar
///     localize_layer: 0        # the one that the localizers see
///     intensity: power         # none, power, reflectivity
///     range_sigma: 0.01        # m, short for noise: {sigma_m: 0.01}
///     noise: {sigma_m: 0.01}   # the keys of lidar_noise.hpp, and glass: true
///     mount_xyz: [0, 0, 0.2]   # m in base
///     mount_rpy: [0, 0, 0]     # rad
LidarSpec read_lidar_figures(YamlReader& map);

/// The lidar under `lidar`, with its `profile`.
LidarSpec read_lidar(YamlReader& root);
/// The lidars under `lidars`: names of the robot's own, or names with their profile and figures.
std::vector<LidarSpec> read_lidars(YamlReader& root);

/// A lidar with what a specification changes; the profile is not looked at.
sim::LidarConfig changed(sim::LidarConfig lidar, const LidarSpec& spec);

}  // namespace castaway::testbed
