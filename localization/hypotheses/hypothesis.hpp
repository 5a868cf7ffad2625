/// One place where the robot may be: a population of particles and what the scans said of it so
/// far.
#pragma once

#include "localization/filter/particle_set.hpp"

namespace castaway::localization {

/// A population (the paper's P^k) with its evidence.
struct Hypothesis {
  int id = 0;  ///< Unique over the life of the localizer.
  Rng rng;     ///< Its own stream, so that others coming and going do not shift it.
  ParticleSet particles;
  PoseMoments belief;       ///< Moments of the particles after the newest correction or prediction.
  double log_weight = 0.0;  ///< Log of the accumulated evidence, on one scale for all hypotheses.
  double log_likelihood = 0.0;  ///< Of the newest scan.
  double quality = 0.0;         ///< Of the newest scan, in [0, 1].
};

}  // namespace castaway::localization
