/// Moments of a population as the published MH-AMCL has them.
#pragma once

#include "localization/filter/particle_set.hpp"
#include "localization/paper/published/published_defects.hpp"

namespace castaway::localization {

/// The weighted moments; the covariance is changed by `unweighted_covariance` (about the unweighted
/// mean, divided by n - 1, n at least 2) and by `unwrapped_yaw`.
PoseMoments published_moments(const ParticleSet& particles, const PublishedDefects& defects);

}  // namespace castaway::localization
