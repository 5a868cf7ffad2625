/// Profiles of commercial lidars, from the files in `lidars/`.
#pragma once

#include <string>
#include <vector>

#include "tools/scenario/sections/lidar_yaml.hpp"

namespace castaway::testbed {

/// Profile of a device.
struct LidarProfile {
  std::string name;    ///< Name of its file, such as "lds-01".
  std::string device;  ///< Full name, such as "ROBOTIS LDS-01".
  std::string source;  ///< Source of the values.
  YamlNode changes;    ///< Its settings, by key.
};

/// Reads `<data>/lidars/<name>.yaml`. Throws std::runtime_error naming the nearest known device, or
/// the file, line and key in error.
LidarProfile load_lidar_profile(const std::string& name);

/// Names of all devices, sorted.
std::vector<std::string> lidar_profile_names();

/// Applies a device's settings to a lidar, except for name, frame and mount. "robot" changes
/// nothing; "ideal" switches off every error.
sim::LidarConfig with_profile(const sim::LidarConfig& lidar, const std::string& profile);

}  // namespace castaway::testbed
