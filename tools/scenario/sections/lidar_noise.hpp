/// The errors of a lidar by the names that they have in YAML.
#pragma once

#include <array>

#include "sim/sensor/lidar_config.hpp"

namespace castaway::testbed {

/// A figure of a lidar's errors: one of the two pointers is set.
struct LidarNoiseKey {
  const char* key;
  double sim::RangeNoise::*range = nullptr;
  double sim::LightEffects::*light = nullptr;

  /// The figure in a configuration.
  [[nodiscard]] double& of(sim::LidarConfig& lidar) const {
    return range != nullptr ? lidar.noise.*range : lidar.light.*light;
  }
};

/// All of them; what they do stands at their fields.
inline constexpr std::array<LidarNoiseKey, 16> kLidarNoiseKeys = {{
    {"sigma_m", &sim::RangeNoise::sigma},
    {"sigma_relative", &sim::RangeNoise::sigma_relative},
    {"bias_m", &sim::RangeNoise::bias},
    {"beam_bias_sigma_m", &sim::RangeNoise::beam_bias_sigma},
    {"resolution_m", &sim::RangeNoise::resolution},
    {"dark_range_m", nullptr, &sim::LightEffects::dark_range},
    {"dropout", nullptr, &sim::LightEffects::dropout},
    {"dropout_far", nullptr, &sim::LightEffects::dropout_far},
    {"dropout_grazing", nullptr, &sim::LightEffects::dropout_grazing},
    {"dropout_dark", nullptr, &sim::LightEffects::dropout_dark},
    {"dust_per_m", nullptr, &sim::LightEffects::dust_rate},
    {"dust_range_m", nullptr, &sim::LightEffects::dust_range},
    {"divergence_deg", nullptr, &sim::LightEffects::divergence_deg},
    {"mixed_reach_m", nullptr, &sim::LightEffects::mixed_reach},
    {"glass_return", nullptr, &sim::LightEffects::glass_return},
    {"glass_angle_deg", nullptr, &sim::LightEffects::glass_angle_deg},
}};

}  // namespace castaway::testbed
