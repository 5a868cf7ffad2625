/// Named odometry settings, from good to bad.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/sensor/wheel_odometry.hpp"

namespace castaway::sim {

/// Names of the profiles, from best to worst: "ideal", "new-wheels", "worn-wheels", "default",
/// "slippery".
std::vector<std::string> odometry_profile_names();

/// The settings of a profile; nothing if the name is unknown.
std::optional<OdometryConfig> odometry_profile(const std::string& name);

}  // namespace castaway::sim
