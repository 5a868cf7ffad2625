#include "sim/sensor/odometry_profiles.hpp"

#include <array>
#include <utility>

namespace castaway::sim {
namespace {

// Random walks are those that `castaway calibrate` finds in recorded logs: by turn, 0.2 degrees per
// root radian in the best, 2 in the median one and 7 in the worst; along, 0.01 to 0.04 m per root
// metre.

/// Recently calibrated; hard wheels on a hard floor.
OdometryConfig new_wheels() {
  OdometryConfig config;
  config.radius_sigma = 0.0001;
  config.track_sigma = 0.001;
  config.drift_along = 0.012;
  config.drift_yaw_deg = 0.02;
  config.drift_turn_deg = 0.2;
  return config;
}

/// Years of service: calibrated once, slips a little now and then.
OdometryConfig worn_wheels() {
  OdometryConfig config;
  config.radius_sigma = 0.0007;
  config.track_sigma = 0.008;
  config.drift_along = 0.03;
  config.drift_yaw_deg = 0.2;
  config.drift_turn_deg = 2.0;
  config.slip.rate = 0.1;
  config.slip.length = 0.03;
  config.slip.share = 0.2;
  config.slip.collision_length = 0.1;
  return config;
}

/// Smooth wheels on a smooth floor, never calibrated.
OdometryConfig slippery() {
  OdometryConfig config;
  config.radius_sigma = 0.006;
  config.track_sigma = 0.08;
  config.drift_along = 0.15;
  config.drift_yaw_deg = 4.0;
  config.drift_turn_deg = 7.0;
  config.slip.rate = 0.6;
  config.slip.length = 0.05;
  config.slip.collision_length = 0.5;
  return config;
}

using Profile = std::pair<const char*, OdometryConfig (*)()>;

OdometryConfig default_odometry() { return {}; }

constexpr std::array<Profile, 5> kProfiles = {{{"ideal", ideal_odometry},
                                               {"new-wheels", new_wheels},
                                               {"worn-wheels", worn_wheels},
                                               {"default", default_odometry},
                                               {"slippery", slippery}}};

}  // namespace

std::vector<std::string> odometry_profile_names() {
  std::vector<std::string> names;
  for (const auto& [name, make] : kProfiles) names.emplace_back(name);
  return names;
}

std::optional<OdometryConfig> odometry_profile(const std::string& name) {
  for (const auto& [known, make] : kProfiles) {
    if (name == known) return make();
  }
  return std::nullopt;
}

}  // namespace castaway::sim
