/// Correction and quality of a population as in the paper (eq. 5 to 7 and 9).
#pragma once

#include <vector>

#include "localization/hypotheses/hypothesis.hpp"
#include "localization/paper/ray_local_model.hpp"

namespace castaway::localization {

/// Weights a population by a scan (eq. 5 to 7) and sets its quality (eq. 9): the mean over
/// particles of the share of hits among the beams. Without beams nothing changes.
void correct_by_rays(const RayLocalModel& model, const ScanPoints& points, Hypothesis& hypothesis);

/// Scores of a scan for every particle.
std::vector<RayLocalScore> ray_scores(const RayLocalModel& model, const ScanPoints& points,
                                      const ParticleSet& particles);
/// Multiplies the weights by the likelihoods (eq. 6).
void multiply_weights(const std::vector<RayLocalScore>& scores, ParticleSet& particles);
/// Quality (eq. 9) for `beams` beams.
double mean_quality(const std::vector<RayLocalScore>& scores, double beams);
/// Sets the quality and the log-weight that follows from it.
void set_quality(double quality, Hypothesis& hypothesis);

}  // namespace castaway::localization
