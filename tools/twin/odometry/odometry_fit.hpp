/// Fits the errors of a differential drive's odometry to a log.
///
/// Odometry is compared with the motion between aligned scans over stretches of two lengths:
/// systematic errors, with the pose of the lidar on the drive, by weighted least squares (A. Censi
/// et al., "Simultaneous calibration of odometry and sensor parameters for mobile robots", IEEE
/// Transactions on Robotics 29, 2013), and random ones as variance components, because the random
/// walk grows with travel and turn and the error of the alignment does not.
#pragma once

#include <optional>
#include <vector>

#include "tools/twin/alignment/motion_samples.hpp"
#include "tools/twin/fits/figure.hpp"
#include "tools/twin/odometry/miss_bins.hpp"
#include "tools/twin/odometry/slip_fit.hpp"

namespace castaway::testbed {

/// True if odometry drives ahead in most of the legs in which the robot reverses on the map, and
/// there are at least ten.
bool is_distance_unsigned(const std::vector<Leg>& legs);

/// The legs with the sign of the distance from the map.
std::vector<Leg> sign_distances(std::vector<Leg> legs);

/// Errors of odometry with intervals, in the terms of `sim::OdometryConfig`. A walk of the yaw that
/// `choose_walk` leaves out is 0, up to what it could be beside the other.
struct OdometryFit {
  Figure radius_error_left;  ///< Relative; of a drive with the track asked for.
  Figure radius_error_right;
  Figure track_error;     ///< Relative.
  Figure drift_along;     ///< [m/sqrt(m)]
  Figure drift_yaw_deg;   ///< [deg/sqrt(m)]
  Figure drift_turn_deg;  ///< [deg/sqrt(rad)]
  Figure scale;           ///< As in `OdometryErrors`.
  Figure yaw_scale;
  Figure curvature;                ///< [rad/m]
  Figure drive_x_m;                ///< [m] Pose of odometry's frame in base, as in `DriveErrors`.
  Figure drive_y_m;                ///< [m]
  Figure drive_yaw_deg;            ///< [deg]
  Figure match_sigma_m;            ///< [m] Error of an aligned pose in each direction.
  Figure stamp_sigma_s;            ///< [s] Error of a scan's stamp against odometry's.
  bool unsigned_distance = false;  ///< Odometry counts reversing as driving ahead.
  SlipFit slip;
  std::vector<MissBin> yaw_by_turn;     ///< Of stretches of 1 m.
  std::vector<MissBin> along_by_speed;  ///< Of the same.
  double way_m = 0.0;                   ///< [m] Travel of the wheels that was used.
  std::size_t stretches = 0;            ///< Long ones.
  double outliers = 0.0;  ///< Share of them that is more than four standard deviations off.
  OdometryNoise noise;    ///< The values of the random errors.
  DriveErrors errors;     ///< The values of the systematic errors.
};

inline constexpr double kMapScale = 0.001;  ///< Standard deviation; relative.

/// Fits legs of a robot with the given track [m]. The intervals of the errors of distance include
/// the scale of the map, which is known within `kMapScale`. Nothing with fewer than 24 stretches of
/// 4 m.
std::optional<OdometryFit> fit_odometry(const std::vector<Leg>& legs, double track);

/// Only the systematic errors, without intervals; no error where `fit_odometry` is nothing.
DriveErrors fit_drive_errors(const std::vector<Leg>& legs, double track);

}  // namespace castaway::testbed
