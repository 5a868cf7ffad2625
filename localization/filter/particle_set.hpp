/// A population of weighted poses.
#pragma once

#include <vector>

#include "localization/geometry/pose_statistics.hpp"

namespace castaway::localization {

/// Particles: poses of base in map and unnormalised log-weights, of the same length.
struct ParticleSet {
  std::vector<SE2> poses;
  std::vector<double> log_weights;

  [[nodiscard]] std::size_t size() const { return poses.size(); }
};

/// Draws `count` equally weighted particles from a Gaussian.
ParticleSet draw_particles(const PoseGaussian& gaussian, int count, Rng& rng);

/// Weights that sum to 1 from their logarithms; equal weights if none is positive.
std::vector<double> normalized_weights(const std::vector<double>& log_weights);
std::vector<double> normalized_weights(const ParticleSet& particles);

/// Effective number of particles: `1 / sum w^2` of normalised weights.
double effective_size(const std::vector<double>& weights);

/// Weighted moments of the population.
PoseMoments moments(const ParticleSet& particles);

}  // namespace castaway::localization
