#include "localization/filter/particle_set.hpp"

#include <algorithm>
#include <cmath>

namespace castaway::localization {

ParticleSet draw_particles(const PoseGaussian& gaussian, int count, Rng& rng) {
  ParticleSet particles;
  for (int i = 0; i < count; ++i) particles.poses.push_back(gaussian.sample(rng));
  particles.log_weights.assign(particles.poses.size(), 0.0);
  return particles;
}

std::vector<double> normalized_weights(const std::vector<double>& log_weights) {
  std::vector<double> weights(log_weights.size());
  if (weights.empty()) return weights;
  const double top = *std::max_element(log_weights.begin(), log_weights.end());
  double sum = 0.0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    weights[i] = std::isfinite(top) ? std::exp(log_weights[i] - top) : 1.0;
    sum += weights[i];
  }
  for (double& w : weights) w /= sum;
  return weights;
}

std::vector<double> normalized_weights(const ParticleSet& particles) {
  return normalized_weights(particles.log_weights);
}

double effective_size(const std::vector<double>& weights) {
  double squares = 0.0;
  for (const double w : weights) squares += w * w;
  return squares > 0.0 ? 1.0 / squares : 0.0;
}

PoseMoments moments(const ParticleSet& particles) {
  return pose_moments(particles.poses, normalized_weights(particles));
}

}  // namespace castaway::localization
