/// Reseed: particles of low weight make room for new ones near the winners (paper, section III-C).
///
/// Differs from the paper (`reseed_losers`): winners are drawn by weight (systematic), and the
/// place of the losers is taken by draws around the refined winner with the covariance of the
/// score's curvature: the fewer particles still carry weight, the more.
#pragma once

#include <optional>

#include "localization/filter/particle_set.hpp"

namespace castaway::localization {

/// How many particles a population has.
struct ReseedConfig {
  int min_particles = 50;   ///< When it is sure of its place.
  int max_particles = 200;  ///< When it is spread by `wide_spread` or more.
  double wide_spread =
      0.3;  ///< [m] Standard deviation of the position at which max_particles are used.
  double effective_share =
      0.5;  ///< Reseed ahead of time when fewer particles than this share carry the weight.
};

/// Throws std::invalid_argument where a figure is out of its range.
void validate(const ReseedConfig& config);

/// Number of particles for a population of this covariance: grows with its spread.
int particle_count(const ReseedConfig& config, const Eigen::Matrix3d& covariance);

/// Draws a new, equally weighted population of `count`: survivors by weight, the rest from `winner`
/// if there is one. The share of survivors is the share of particles that carry weight.
ParticleSet reseed(const ParticleSet& particles, int count,
                   const std::optional<PoseGaussian>& winner, Rng& rng);

}  // namespace castaway::localization
