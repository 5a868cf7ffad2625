/// Reseed as the paper has it (section III-C): sorted by weight, the losers make room for copies
/// near winners.
///
/// Where the paper is silent: the winner's index is drawn from a half-normal distribution with
/// standard deviation winners / 2; a copy is spread with a fixed noise; all weights start anew, as
/// the copies have none of their own; the number of particles changes by a fixed step towards its
/// limits.
#pragma once

#include "localization/filter/particle_set.hpp"
#include "localization/published_defects.hpp"

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

/// The next, equally weighted population of a set that is not empty. `defects`: `winner_unused`,
/// `jitter_squared`, and those of the covariance.
ParticleSet reseed_losers(const LoserReseedConfig& config, const ParticleSet& particles, Rng& rng,
                          const PublishedDefects& defects = {});

}  // namespace castaway::localization
