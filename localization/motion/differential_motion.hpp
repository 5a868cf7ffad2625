/// Odometry motion model of a differential drive: turn, drive, turn.
///
/// S. Thrun, W. Burgard, D. Fox, "Probabilistic Robotics" (2005), table 5.6, with the alphas as
/// coefficients of variances, and with the turns of a robot that drives backwards counted as small,
/// as in Nav2's AMCL.
#pragma once

#include "localization/geometry/random.hpp"
#include "localization/geometry/se2.hpp"

namespace castaway::localization {

/// Coefficients of the variances.
struct DifferentialMotionConfig {
  double alpha1 = 0.2;  ///< Turn noise from turning: rad^2 per rad^2.
  double alpha2 = 0.2;  ///< Turn noise from driving: rad^2 per m^2.
  double alpha3 = 0.2;  ///< Drive noise from driving: m^2 per m^2.
  double alpha4 = 0.2;  ///< Drive noise from turning: m^2 per rad^2.
};

/// One step of odometry, conditioned once and applied to many poses.
class DifferentialMotion {
 public:
  /// `u` is `T_base0_base1`.
  DifferentialMotion(const SE2& u, const DifferentialMotionConfig& config);

  /// Draws the pose after the step.
  [[nodiscard]] SE2 sample(const SE2& T_map_base0, Rng& rng) const;

  /// The decomposed step and its noise.
  struct Parts {
    double rot1 = 0.0;         ///< [rad]
    double trans = 0.0;        ///< [m]
    double rot2 = 0.0;         ///< [rad]
    double sigma_rot1 = 0.0;   ///< [rad]
    double sigma_trans = 0.0;  ///< [m]
    double sigma_rot2 = 0.0;   ///< [rad]
  };
  [[nodiscard]] const Parts& parts() const { return parts_; }

 private:
  Parts parts_;
};

}  // namespace castaway::localization
