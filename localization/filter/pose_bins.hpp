/// Histogram bins of poses: the number of bins that a population occupies, and its clusters.
///
/// D. Fox, "Adapting the Sample Size in Particle Filters Through KLD-Sampling", IJRR 22 (2003).
#pragma once

#include <array>
#include <map>
#include <vector>

#include "localization/filter/particle_set.hpp"

namespace castaway::localization {

/// Parameters of KLD-sampling.
struct KldConfig {
  double bin_m = 0.5;       ///< [m] Edge of a bin in x and y.
  double bin_rad = 0.1745;  ///< [rad] Edge of a bin in yaw (10 degrees), rounded to a
                            ///< whole number of bins in a turn.
  double error = 0.05;      ///< Bound of the Kullback-Leibler distance.
  double z = 0.99;          ///< Used as the quantile itself instead of the probability, as in AMCL.
  int min_particles = 500;
  int max_particles = 2000;
};

/// Index of a bin in x, y and yaw. That in yaw lies in [0, bins of a full turn).
using PoseBin = std::array<int, 3>;

/// The bin of a pose.
PoseBin bin_of(const KldConfig& config, const SE2& pose);

/// Number of particles that suffices for `bins` occupied bins (Fox 2003, eq. 7), within the
/// configured limits.
int kld_limit(const KldConfig& config, std::size_t bins);

/// A set of adjacent bins (edges and corners count, also across a yaw of 180 degrees) and the
/// particles in them.
struct Cluster {
  std::vector<std::size_t> particles;  ///< Indices.
  double weight = 0.0;                 ///< Share of the population.
  SE2 mean;
};

/// The heaviest cluster of a population, which must not be empty.
Cluster heaviest_cluster(const KldConfig& config, const ParticleSet& particles);

}  // namespace castaway::localization
