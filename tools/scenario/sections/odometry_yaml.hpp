/// Odometry and the inertial measurement unit in YAML.
#pragma once

#include <optional>

#include "sim/sensor/imu.hpp"
#include "sim/sensor/wheel_odometry.hpp"
#include "tools/scenario/yaml/settings.hpp"

namespace castaway::testbed {

/// Settings under `odometry`, except for `profile`.
void fields(Settings settings, sim::OdometryConfig& odometry);

/// Reads the map under `odometry`: a profile (`sim::odometry_profile_names`) and changes to it. All
/// settings of the profile are written into the document.
sim::OdometryConfig read_odometry(YamlReader& root);

/// Settings under `imu`.
void fields(Settings settings, sim::ImuConfig& imu);

/// Reads `imu`: true, false, or a map of settings; nothing without it.
std::optional<sim::ImuConfig> read_imu(YamlReader& root);

}  // namespace castaway::testbed
