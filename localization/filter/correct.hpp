/// Correction: multiplies every particle's weight by the likelihood of the scan (paper, eq. 6, in
/// logarithms).
#pragma once

#include <concepts>

#include "localization/filter/particle_set.hpp"
#include "localization/sensor/scan_points.hpp"

namespace castaway::localization {

/// What the filter needs of an observation model: the log-likelihood of a scan from a pose. The
/// points have heights, and a model whose map is not planar lifts the pose (`to_se3`).
template <typename Model>
concept ObservationModel = requires(const Model& model, const ScanPoints& points,
                                    const SE2& T_map_base) {
  { model.log_likelihood(points, T_map_base) } -> std::convertible_to<double>;
};

/// Weights all particles by the scan.
template <ObservationModel Model>
void correct(ParticleSet& particles, const Model& model, const ScanPoints& points) {
  for (std::size_t i = 0; i < particles.size(); ++i) {
    particles.log_weights[i] += model.log_likelihood(points, particles.poses[i]);
  }
}

}  // namespace castaway::localization
