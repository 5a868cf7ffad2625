/// Prediction: every particle takes the measured step with noise of its own (paper, eq. 4).
#pragma once

#include "localization/filter/particle_set.hpp"
#include "localization/motion/odometry_noise.hpp"

namespace castaway::localization {

/// Moves all particles.
void predict(ParticleSet& particles, const OdometryMotion& motion, Rng& rng);

}  // namespace castaway::localization
