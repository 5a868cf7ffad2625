/// Fits the errors of a differential drive's odometry to a log.
///
/// Odometry is compared with the motion between aligned scans over stretches of two lengths:
/// systematic errors by weighted least squares, and random ones as variance components, because the
/// random walk grows with the length and the error of the alignment does not.
#pragma once

#include <optional>
#include <vector>

#include "tools/alignment/motion_samples.hpp"
#include "tools/twin/fits/figure.hpp"

namespace castaway::testbed {

/// Errors of odometry with intervals, in the terms of `sim::OdometryConfig`.
struct OdometryFit {
  Figure radius_error_left;  ///< Relative; of a drive with the track asked for.
  Figure radius_error_right;
  Figure track_error;    ///< Relative.
  Figure drift_along;    ///< [m/sqrt(m)]
  Figure drift_yaw_deg;  ///< [deg/sqrt(m)]
  Figure scale;          ///< As in `OdometryErrors`.
  Figure yaw_scale;
  Figure curvature;           ///< [rad/m]
  Figure match_sigma_m;       ///< [m] Error of an aligned pose along its heading.
  double way_m = 0.0;         ///< [m] Travel of the wheels that was used.
  std::size_t stretches = 0;  ///< Long ones.
  double outliers = 0.0;      ///< Share of them that is more than four standard deviations off.
  OdometryErrors errors;      ///< The values of scale, yaw_scale and curvature.
};

inline constexpr double kMapScale = 0.001;  ///< Standard deviation; relative.

/// Fits legs of a robot with the given track [m]. The intervals of the errors of distance include
/// the scale of the map, which is known within `kMapScale`. Nothing with fewer than 24 stretches of
/// 4 m.
std::optional<OdometryFit> fit_odometry(const std::vector<Leg>& legs, double track);

}  // namespace castaway::testbed
