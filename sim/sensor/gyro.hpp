/// A gyro about the robot's vertical axis.
#pragma once

#include "sim/common/random.hpp"

namespace castaway::sim {

/// Error model of a gyro. Defaults: a MEMS gyro of a mobile base, calibrated at rest.
struct GyroConfig {
  double noise_deg = 0.01;   ///< [deg/sqrt(s)] Random walk of the angle.
  double bias_deg_s = 0.01;  ///< [deg/s] Standard deviation of the bias that calibration left.
  double bias_walk_deg_s = 0.001;  ///< [deg/s/sqrt(s)] Random walk of the bias.
  double scale_sigma = 0.002;      ///< Relative error of every turn, drawn once.
};

/// @throws std::invalid_argument naming the field and the remedy.
void validate(const GyroConfig& config);

/// Integrates a noisy rate.
class Gyro {
 public:
  /// Draws bias and scale from `rng`, and keeps it.
  Gyro(const GyroConfig& config, Rng rng);

  /// Returns the measured turn for a true turn [rad] within `dt` [s].
  double measure(double turn, double dt);

 private:
  GyroConfig config_;
  Rng rng_;
  double bias_ = 0.0;  ///< [rad/s]
  double scale_ = 1.0;
};

}  // namespace castaway::sim
