/// Moments of a population as in the published MH-AMCL.
#pragma once

#include "localization/filter/particle_set.hpp"
#include "localization/paper/published/published_defects.hpp"

namespace castaway::localization {

/// The weighted moments. `unweighted_covariance` (about the unweighted mean, divided by n - 1, n at
/// least 2) and `unwrapped_yaw` change the covariance.
PoseMoments published_moments(const ParticleSet& particles, const PublishedDefects& defects);

}  // namespace castaway::localization
