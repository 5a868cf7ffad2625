/// Reseed: replaces particles of low weight by new ones near the winners (paper, section III-C).
///
/// Unlike the paper (`reseed_losers`), winners are drawn by weight (systematic), and losers are
/// replaced by draws around the refined winner with the covariance of the score's curvature. The
/// fewer particles carry weight, the more are replaced.
#pragma once

#include <optional>

#include "localization/filter/particle_set.hpp"

namespace castaway::localization {

/// Size of a population.
struct ReseedConfig {
  int min_particles = 50;   ///< Number for a certain pose.
  int max_particles = 200;  ///< Number for a spread of `wide_spread` or more.
  /// [m] Standard deviation of the position at which max_particles are used.
  double wide_spread = 0.3;
  /// Share of particles that must carry weight; with fewer, the population is reseeded early.
  double effective_share = 0.5;
  /// A refined winner is averaged over so many poses to either side along its least certain
  /// direction (`average_along_ridge`); 0: it is the peak.
  int ridge_steps = 0;
};

/// @throws std::invalid_argument if a value is out of range.
void validate(const ReseedConfig& config);

/// Number of particles for a population with this covariance; grows with its spread.
int particle_count(const ReseedConfig& config, const Eigen::Matrix3d& covariance);

/// Draws a new, equally weighted population of `count`: survivors by weight, the rest from `winner`
/// if there is one. The share of survivors is that of the particles that carry weight.
ParticleSet reseed(const ParticleSet& particles, int count,
                   const std::optional<PoseGaussian>& winner, Rng& rng);

}  // namespace castaway::localization
