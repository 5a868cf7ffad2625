/// Poses sorted into bins of a histogram: how many places a population covers, and which of them
/// hang together.
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
  double bin_rad = 0.1745;  ///< [rad] Edge of a bin in yaw (10 degrees).
  double error = 0.05;      ///< Bound of the Kullback-Leibler distance.
  double z = 0.99;  ///< Used as the quantile of the normal distribution itself, as AMCL has it.
  int min_particles = 500;
  int max_particles = 2000;
};

/// Index of a bin.
using PoseBin = std::array<int, 3>;

/// The bin of a pose.
PoseBin bin_of(const KldConfig& config, const SE2& pose);

/// Particles that suffice for `bins` occupied bins (Fox 2003, eq. 7), within the limits of the
/// configuration.
int kld_limit(const KldConfig& config, std::size_t bins);

/// A set of bins that touch (edges and corners count) and the particles within.
struct Cluster {
  std::vector<std::size_t> particles;  ///< Indices.
  double weight = 0.0;                 ///< Share of the population.
  SE2 mean;
};

/// The heaviest cluster of a population that is not empty.
Cluster heaviest_cluster(const KldConfig& config, const ParticleSet& particles);

}  // namespace castaway::localization
