/// Settings of AMCL, with Nav2's names and defaults.
#pragma once

#include <numbers>

#include "localization/filter/pose_bins.hpp"
#include "localization/filter/recovery_averages.hpp"
#include "localization/input/intake.hpp"
#include "localization/motion/differential_motion.hpp"
#include "localization/sensor/beam_model.hpp"
#include "localization/sensor/likelihood_field_prob.hpp"

namespace castaway::localization {

/// Sensor model, Nav2's `laser_model_type`.
enum class AmclSensorModel {
  kLikelihoodField,      ///< `1 + sum pz^3`; pz from the wall nearest to the end point.
  kLikelihoodFieldProb,  ///< `prod pz`, with beam skipping.
  kBeam,                 ///< `1 + sum pz^3`; pz from the range to the first wall.
};

/// Spread of a start without covariance.
struct InitialSpread {
  double sigma_m = 0.5;                        ///< [m] In x and y.
  double sigma_yaw = std::numbers::pi / 12.0;  ///< [rad]
};

/// Settings.
struct AmclConfig {
  DifferentialMotionConfig motion;
  AmclSensorModel model = AmclSensorModel::kLikelihoodField;
  LikelihoodFieldConfig sensor;
  BeamSkipConfig beam_skip;  ///< Used by kLikelihoodFieldProb only.
  BeamModelConfig beam;      ///< Used by kBeam only.
  KldConfig kld;
  RecoveryConfig recovery;
  InitialSpread initial;       ///< Of a start with zero covariance.
  double update_min_d = 0.25;  ///< [m] Least motion along x or y of odom between updates.
  double update_min_a = 0.2;   ///< [rad] Least turn between updates.
  /// Updates at every scan, also without motion, as Nav2 does on `request_nomotion_update`.
  bool update_at_rest = false;
  int max_beams = 60;        ///< Number of beams used, at equal steps of their index.
  double max_range = 100.0;  ///< [m] Longer returns are ignored; also limits the lidar's own range.
  /// Nav2's grid convention: map and estimates are shifted by half a cell towards -x and -y.
  bool half_cell_shift = false;
  IntakeConfig intake;
};

/// @throws std::invalid_argument naming a value that is out of range.
void validate(const AmclConfig& config);

}  // namespace castaway::localization
