/// A place where the robot may be: a population and its accumulated evidence.
#pragma once

#include "localization/filter/gaussian_mixture.hpp"
#include "localization/filter/particle_set.hpp"

namespace castaway::localization {

/// A population (the paper's P^k) with its evidence.
struct Hypothesis {
  int id = 0;  ///< Unique over the lifetime of the localizer.
  Rng rng;     ///< Its own stream, so that creating or removing others does not shift its draws.
  ParticleSet particles;        ///< Empty if the belief is a mixture.
  GaussianMixture mixture;      ///< Empty if the belief is in particles.
  PoseMoments belief;           ///< Moments of either after the latest correction, moved by the
                                ///< predictions since.
  double log_weight = 0.0;      ///< [nats] Accumulated evidence, on one scale for all hypotheses.
  double log_likelihood = 0.0;  ///< [nats] Of the newest scan.
  double quality = 0.0;         ///< Of the newest scan, in [0, 1].
  int replaces = -1;            ///< Id of the output that it corrects after a rescue; -1: none.

  /// Moments of the particles or of the mixture as they are now.
  [[nodiscard]] PoseMoments moments() const {
    return mixture.empty() ? localization::moments(particles) : localization::moments(mixture);
  }
};

}  // namespace castaway::localization
