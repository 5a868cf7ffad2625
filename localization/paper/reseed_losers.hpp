/// Reseed as in the paper (section III-C): the particles of lowest weight (losers) are replaced by
/// copies near those of highest weight (winners).
///
/// Where the paper is silent: the winner's index is drawn from a half-normal distribution with
/// standard deviation winners / 2; a copy is displaced by noise of a fixed size; all weights
/// are reset, because copies have none; the number of particles changes by a fixed step within its
/// limits.
#pragma once

#include <functional>

#include "localization/filter/particle_set.hpp"

namespace castaway::localization {

/// Parameters of the reseed.
struct LoserReseedConfig {
  double losers = 0.8;       ///< Share of the particles that are replaced.
  double winners = 0.1;      ///< Share of the particles that are copied.
  double spread_m = 0.05;    ///< [m] Standard deviation of a copy from its winner.
  double spread_rad = 0.05;  ///< [rad] Standard deviation of its yaw.
  int min_particles = 30;
  int max_particles = 200;
  int step = 30;               ///< Number of particles added or removed at a time.
  double high_spread_m = 0.2;  ///< [m] Particles are added above this spread of the position.
  double low_spread_m = 0.1;   ///< [m] Particles are removed below this spread.
};

/// @throws std::invalid_argument if a value is out of range.
void validate(const LoserReseedConfig& config);

/// Returns the next, equally weighted population. Requires particles.
ParticleSet reseed_losers(const LoserReseedConfig& config, const ParticleSet& particles, Rng& rng);

/// The parts of a reseed in which variants of the method differ.
struct LoserReseedRule {
  Eigen::Matrix3d covariance;  ///< Of the population; determines the number of particles.
  /// Rank by weight (0: the heaviest) of the particle that is copied to replace loser number
  /// `loser` (from 0), given the rank of the winner drawn for it.
  std::function<std::size_t(std::size_t loser, std::size_t winner)> source;
};

/// The same with another rule.
ParticleSet reseed_losers(const LoserReseedConfig& config, const ParticleSet& particles,
                          const LoserReseedRule& rule, Rng& rng);

}  // namespace castaway::localization
