/// Settings of AMCL, by Nav2's names and with its defaults.
#pragma once

#include <numbers>

#include "localization/filter/pose_bins.hpp"
#include "localization/filter/recovery_averages.hpp"
#include "localization/motion/differential_motion.hpp"
#include "localization/sensor/beam_model.hpp"
#include "localization/sensor/intake.hpp"
#include "localization/sensor/likelihood_field_prob.hpp"

namespace castaway::localization {

/// How the beams of a scan make a weight: `laser_model_type`.
enum class AmclSensorModel {
  kLikelihoodField,      ///< `1 + sum pz^3`, pz by the wall nearest to the end point.
  kLikelihoodFieldProb,  ///< `prod pz`, with beam skipping.
  kBeam,                 ///< `1 + sum pz^3`, pz by the range to the first wall.
};

/// Spread of a start that comes without one.
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
  InitialSpread initial;       ///< Of a start whose covariance is 0.
  double update_min_d = 0.25;  ///< [m] Along x or y of odom since the last update.
  double update_min_a = 0.2;   ///< [rad]
  /// Updates at every scan, moved or not: what Nav2 does on `request_nomotion_update`.
  bool update_at_rest = false;
  int max_beams = 60;        ///< Beams used, by equal steps of their index.
  double max_range = 100.0;  ///< [m] Longer returns are ignored; also limits the lidar's own range.
  /// Nav2's grid convention: the map lies half a cell towards -x and -y of where its origin says,
  /// and so do the estimates.
  bool half_cell_shift = false;
  IntakeConfig intake;
};

/// Throws std::invalid_argument naming the figure that is out of its range.
void validate(const AmclConfig& config);

}  // namespace castaway::localization
