/// Odometry motion model of the paper (eq. 3 and 4): the measured step plus noise.
#pragma once

#include <Eigen/Core>

#include "localization/geometry/random.hpp"
#include "localization/geometry/se2.hpp"

namespace castaway::localization {

/// Variances grow linearly with distance and turn, so that the noise of a path does not depend on
/// the rate of prediction.
struct OdometryNoiseConfig {
  double trans_per_m = 0.10;    ///< [m / sqrt(m)] Spread of the position after one metre.
  double trans_per_rad = 0.02;  ///< [m / sqrt(rad)] Spread of the position after one radian.
  double rot_per_m = 0.06;      ///< [rad / sqrt(m)] Spread of the yaw after one metre.
  double rot_per_rad = 0.10;    ///< [rad / sqrt(rad)] Spread of the yaw after one radian.
};

/// @throws std::invalid_argument if a value is negative.
void validate(const OdometryNoiseConfig& config);

/// One step of odometry, conditioned once and applied to many poses.
class OdometryMotion {
 public:
  /// `u` is `T_base0_base1`, the step as odometry measured it.
  OdometryMotion(const SE2& u, const OdometryNoiseConfig& config);

  /// Draws `x' = x * (u + e)`. A step of exactly zero moves nothing and draws nothing.
  [[nodiscard]] SE2 sample(const SE2& T_map_base0, Rng& rng) const;
  /// Covariance of e in the frame of base0.
  [[nodiscard]] Eigen::Matrix3d covariance() const;

 private:
  SE2 u_;
  double sigma_trans_;
  double sigma_rot_;
};

/// Returns the covariance in map of a step with `covariance_base` in the frame of base0.
Eigen::Matrix3d rotate_to_map(const Eigen::Matrix3d& covariance_base, double yaw);

}  // namespace castaway::localization
