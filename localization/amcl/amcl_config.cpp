#include "localization/amcl/amcl_config.hpp"

#include <stdexcept>

namespace castaway::localization {

void validate(const AmclConfig& config) {
  const auto require = [](bool condition, const char* text) {
    if (!condition) throw std::invalid_argument(text);
  };
  for (const double alpha :
       {config.motion.alpha1, config.motion.alpha2, config.motion.alpha3, config.motion.alpha4,
        config.recovery.alpha_slow, config.recovery.alpha_fast, config.sensor.z_hit,
        config.sensor.z_rand, config.update_min_d, config.update_min_a}) {
    require(alpha >= 0.0, "alphas, z_hit, z_rand, update_min_d, update_min_a must not be negative");
  }
  require(config.sensor.sigma_hit > 0.0, "sigma_hit must be positive");
  require(config.sensor.max_distance > 0.0, "max_distance must be positive");
  validate(config.beam);
  require(config.kld.error > 0.0, "the error of KLD-sampling must be positive");
  require(config.kld.min_particles >= 1 && config.kld.max_particles >= config.kld.min_particles,
          "particles: need 1 <= min_particles <= max_particles");
  require(config.initial.sigma_m > 0.0 && config.initial.sigma_yaw > 0.0,
          "the initial spread must be positive");
  require(config.max_beams >= 2, "max_beams must be at least 2");
  require(config.max_range > 0.0, "max_range must be positive");
}

}  // namespace castaway::localization
