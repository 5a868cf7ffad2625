/// KLD-sampling: draws particles by weight until their number suffices for the bins that they
/// occupy.
///
/// D. Fox, "Adapting the Sample Size in Particle Filters Through KLD-Sampling", IJRR 22 (2003),
/// table 1; with random particles as in Probabilistic Robotics, table 8.3.
#pragma once

#include "localization/filter/pose_bins.hpp"
#include "localization/map/occupancy_grid.hpp"

namespace castaway::localization {

/// Draws a new, equally weighted population from `particles` (not empty). Each particle is instead
/// drawn from `anywhere` with probability `random_share`.
ParticleSet kld_resample(const ParticleSet& particles, const KldConfig& config,
                         const FreeSpace& anywhere, double random_share, Rng& rng);

}  // namespace castaway::localization
