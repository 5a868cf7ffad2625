/// Odometry in YAML.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "sim/sensor/wheel_odometry.hpp"
#include "tools/scenario/sections/scenario.hpp"
#include "tools/scenario/yaml/yaml_reader.hpp"

namespace castaway::testbed {

/// A figure of slip by its name in YAML.
struct SlipKey {
  const char* key;
  double sim::SlipConfig::*field;
};

inline constexpr std::array<SlipKey, 5> kSlipKeys = {{
    {"rate_per_m", &sim::SlipConfig::rate},
    {"length_m", &sim::SlipConfig::length},
    {"share", &sim::SlipConfig::share},
    {"collision_length_m", &sim::SlipConfig::collision_length},
    {"zone_spread", &sim::SlipConfig::zone_spread},
}};

/// Names of the profiles; as `sim::odometry_profile_names`.
inline const std::vector<std::string> kOdometryProfiles = {"ideal", "new-wheels", "worn-wheels",
                                                           "default", "slippery"};

/// Reads the map under `odometry`:
///
///     odometry:
///       profile: worn-wheels   # ideal, new-wheels, worn-wheels, default, slippery
///       ticks_per_turn: 4096   # 0: continuous
///       radius_sigma: 0.005    # relative error of each wheel, drawn once
///       track_sigma: 0.01      # relative error of the track, drawn once
///       drift_along: 0.012     # m per root of a metre
///       drift_yaw_deg: 0.7     # deg per root of a metre
///       slip: {rate_per_m: 0.2, length_m: 0.1, share: 0.3, collision_length_m: 0.2,
///              zones: true, zone_spread: 0.5}
///       gyro: {noise_deg: 0.01, bias_deg_s: 0.01, bias_walk_deg_s: 0.001, scale_sigma: 0.002}
OdometrySpec read_odometry(YamlReader& root);

}  // namespace castaway::testbed
