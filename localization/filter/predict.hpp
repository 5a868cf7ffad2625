/// Prediction: moves every particle by the measured step with independent noise (paper, eq. 4).
#pragma once

#include "localization/filter/particle_set.hpp"

namespace castaway::localization {

/// Moves all particles. `Motion` has `sample(T_map_base, rng)`.
template <typename Motion>
void predict(ParticleSet& particles, const Motion& motion, Rng& rng) {
  for (SE2& pose : particles.poses) pose = motion.sample(pose, rng);
}

}  // namespace castaway::localization
