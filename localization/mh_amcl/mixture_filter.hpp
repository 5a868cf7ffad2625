/// Correction of a population that is a mixture of normal distributions: each component climbs to
/// the maximum of the scan and odometry likelihoods together, and takes the curvature there.
///
/// An iterated extended Kalman filter, for which the scan is one measurement: B. M. Bell, F. W.
/// Cathey, "The Iterated Kalman Filter Update as a Gauss-Newton Method", IEEE Transactions on
/// Automatic Control 38 (1993). A component's weight changes by Laplace's approximation of its
/// evidence.
#pragma once

#include "localization/filter/gaussian_mixture.hpp"
#include "localization/matching/pose_climber.hpp"

namespace castaway::localization {

/// Corrects a mixture by a scan. `refine` is that of hill climbing.
void correct(GaussianMixture& mixture, const MixtureConfig& config, const PoseClimber& climber,
             const RefineConfig& refine, const ScanPoints& points);

}  // namespace castaway::localization
