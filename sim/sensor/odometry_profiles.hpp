/// How well robots count their wheels: named settings of odometry.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/sensor/wheel_odometry.hpp"

namespace castaway::sim {

/// Names of the profiles, from the best to the worst: "ideal", "new-wheels",
/// "worn-wheels", "default", "slippery".
std::vector<std::string> odometry_profile_names();

/// The settings of a profile; nothing if there is none of that name.
std::optional<OdometryConfig> odometry_profile(const std::string& name);

}  // namespace castaway::sim
