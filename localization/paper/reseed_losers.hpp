/// Reseed as the paper has it (section III-C): sorted by weight, the losers make room for copies
/// near winners.
///
/// Where the paper is silent: the winner's index is drawn from a half-normal distribution with
/// standard deviation winners / 2; a copy is spread with a fixed noise; all weights start anew, as
/// the copies have none of their own; the number of particles changes by a fixed step towards its
/// limits.
#pragma once

#include <functional>

#include "localization/filter/particle_set.hpp"

namespace castaway::localization {

/// Parameters of the reseed.
struct LoserReseedConfig {
  double losers = 0.8;       ///< Share of the particles that are replaced.
  double winners = 0.1;      ///< Share of the particles that are copied.
  double spread_m = 0.05;    ///< [m] Standard deviation of a copy about its winner...
  double spread_rad = 0.05;  ///< [rad] ...and of its yaw.
  int min_particles = 30;
  int max_particles = 200;
  int step = 30;  ///< Particles that come or go at a time.
  double high_spread_m =
      0.2;  ///< [m] More particles above this standard deviation of the position...
  double low_spread_m = 0.1;  ///< [m] ...fewer below this.
};

/// Throws std::invalid_argument where a figure is out of its range.
void validate(const LoserReseedConfig& config);

/// The next, equally weighted population of a set that is not empty.
ParticleSet reseed_losers(const LoserReseedConfig& config, const ParticleSet& particles, Rng& rng);

/// What a reseed goes by.
struct LoserReseedRule {
  Eigen::Matrix3d covariance;  ///< Of the population: how many particles it gets.
  /// Rank by weight (0: the heaviest) of the particle that takes the place of loser number `loser`
  /// (from 0), for which a winner's rank was drawn.
  std::function<std::size_t(std::size_t loser, std::size_t winner)> source;
};

/// The same by another rule.
ParticleSet reseed_losers(const LoserReseedConfig& config, const ParticleSet& particles,
                          const LoserReseedRule& rule, Rng& rng);

}  // namespace castaway::localization
