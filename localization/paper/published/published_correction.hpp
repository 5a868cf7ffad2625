/// Correction and reseed of a population as in the published MH-AMCL.
#pragma once

#include "localization/hypotheses/hypothesis.hpp"
#include "localization/paper/published/published_defects.hpp"
#include "localization/paper/ray_local_model.hpp"
#include "localization/paper/reseed_losers.hpp"

namespace castaway::localization {

/// The model's settings. With `summed_weights`, hits are the density `N(error; 0, sigma)` clamped
/// to 1, so that with sigma 0.05 m every error up to 2 sigma is a perfect hit.
RayLocalConfig published_sensor(RayLocalConfig config, const PublishedDefects& defects);

/// `correct_by_rays` with `summed_weights` (which requires a model of `published_sensor`), and with
/// the defects of quality and covariance.
void published_correct(const RayLocalModel& model, const ScanPoints& points,
                       const PublishedDefects& defects, Hypothesis& hypothesis);

/// `reseed_losers` with `winner_unused`, `jitter_squared` and the defects of the covariance.
ParticleSet published_reseed(LoserReseedConfig config, const ParticleSet& particles,
                             const PublishedDefects& defects, Rng& rng);

}  // namespace castaway::localization
