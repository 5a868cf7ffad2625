/// Correction: every particle's weight is multiplied by the likelihood of the scan (paper, eq. 6,
/// in logarithms).
#pragma once

#include <concepts>

#include "localization/filter/particle_set.hpp"
#include "localization/sensor/scan_points.hpp"

namespace castaway::localization {

/// What the filter asks of a map: the log-likelihood of a scan from a pose. The points carry their
/// heights, and the model lifts the pose (`to_se3`) if its map is not planar.
template <typename Model>
concept ObservationModel = requires(const Model& model, const ScanPoints& points,
                                    const SE2& T_map_base) {
  { model.log_likelihood(points, T_map_base) } -> std::convertible_to<double>;
};

/// Weighs all particles by the scan.
template <ObservationModel Model>
void correct(ParticleSet& particles, const Model& model, const ScanPoints& points) {
  for (std::size_t i = 0; i < particles.size(); ++i) {
    particles.log_weights[i] += model.log_likelihood(points, particles.poses[i]);
  }
}

}  // namespace castaway::localization
