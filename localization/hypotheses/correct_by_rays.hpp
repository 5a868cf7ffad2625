/// Correction and quality of a population as the paper has them (eq. 5 to 7 and 9).
#pragma once

#include "localization/hypotheses/hypothesis.hpp"
#include "localization/published_defects.hpp"
#include "localization/sensor/ray_local_model.hpp"

namespace castaway::localization {

/// Weighs a population by a scan (eq. 5 to 7) and takes its quality (eq. 9): mean over particles of
/// the share of hits among the beams. Nothing changes without beams. `defects`: `summed_weights`
/// (which wants a model with `clamped_density`), those of the quality and of the covariance.
void correct_by_rays(Hypothesis& hypothesis, const RayLocalModel& model, const ScanPoints& points,
                     const PublishedDefects& defects = {});

}  // namespace castaway::localization
