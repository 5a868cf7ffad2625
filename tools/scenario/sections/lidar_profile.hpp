/// Lidars that can be bought, as files of `lidars/`.
#pragma once

#include <string>
#include <vector>

#include "tools/scenario/sections/lidar_spec.hpp"

namespace castaway::testbed {

/// A device.
struct LidarProfile {
  std::string name;    ///< Of its file: "lds-01".
  std::string device;  ///< In full: "ROBOTIS LDS-01".
  std::string source;  ///< What its figures were taken from.
  YamlNode changes;    ///< Its settings, by their keys.
};

/// Reads `<data>/lidars/<name>.yaml`. Throws std::runtime_error naming the nearest known device,
/// or the file, line and key that is wrong.
LidarProfile load_lidar_profile(const std::string& name);

/// Names of all devices, sorted.
std::vector<std::string> lidar_profile_names();

/// A lidar with a device's figures; name, frame and mount stay. "robot" changes nothing, "ideal"
/// switches every error off.
sim::LidarConfig with_profile(const sim::LidarConfig& lidar, const std::string& profile);

}  // namespace castaway::testbed
