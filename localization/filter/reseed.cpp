#include "localization/filter/reseed.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "localization/filter/resample.hpp"

namespace castaway::localization {

void validate(const ReseedConfig& config) {
  if (config.min_particles < 2 || config.max_particles < config.min_particles) {
    throw std::invalid_argument("particles: need 2 <= min_particles <= max_particles");
  }
  if (!(config.wide_spread > 0.0)) throw std::invalid_argument("wide_spread must be positive");
  if (config.ridge_steps < 0) throw std::invalid_argument("ridge_steps must not be negative");
}

int particle_count(const ReseedConfig& config, const Eigen::Matrix3d& covariance) {
  const double spread = std::sqrt(0.5 * (covariance(0, 0) + covariance(1, 1)));
  const double share = std::min(1.0, spread / config.wide_spread);
  const double extra = share * (config.max_particles - config.min_particles);
  return config.min_particles + static_cast<int>(std::lround(extra));
}

ParticleSet reseed(const ParticleSet& particles, int count,
                   const std::optional<PoseGaussian>& winner, Rng& rng) {
  const std::vector<double> weights = normalized_weights(particles);
  const double share = effective_size(weights) / static_cast<double>(weights.size());
  const auto total = static_cast<std::size_t>(count);
  const auto survivors =
      winner ? static_cast<std::size_t>(std::floor(share * static_cast<double>(total))) : total;
  ParticleSet next;
  next.poses.reserve(total);
  for (const std::size_t i : systematic_resample(weights, survivors, rng)) {
    next.poses.push_back(particles.poses[i]);
  }
  while (next.poses.size() < total) next.poses.push_back(winner->sample(rng));
  next.log_weights.assign(total, 0.0);
  return next;
}

}  // namespace castaway::localization
