/// Likelihood-field model as a product over beams, with beam skipping: AMCL's
/// `likelihood_field_prob`.
///
/// The weight of a pose is `prod pz` (Probabilistic Robotics, table 6.3). A beam that few particles
/// explain (a person) is skipped for all of them, unless so many beams would be skipped that the
/// population itself must be wrong.
#pragma once

#include <vector>

#include "localization/sensor/likelihood_field.hpp"

namespace castaway::localization {

/// Beam skipping, with Nav2's names and defaults.
struct BeamSkipConfig {
  bool enabled = true;
  double distance = 0.5;   ///< [m] A particle explains a beam that ends this close to a wall.
  double threshold = 0.3;  ///< A beam explained by this share of the particles or fewer is skipped.
  /// No beam is skipped if at least this share of all beams would be.
  double error_threshold = 0.9;
};

/// True for beams that are used. `distances[particle][beam]` [m]: from the end point to the nearest
/// wall.
std::vector<bool> beams_to_use(const std::vector<std::vector<double>>& distances,
                               const BeamSkipConfig& config);

/// Log-weight of each pose. `range_max` [m]: of the lidar.
std::vector<double> prob_log_weights(const LikelihoodField& field, const ScanPoints& points,
                                     const std::vector<SE2>& poses, double range_max,
                                     const BeamSkipConfig& config);

}  // namespace castaway::localization
