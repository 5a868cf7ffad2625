/// Poses in the plane: rigid transforms, and a pose with its uncertainty.
#pragma once

#include <optional>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace castaway::localization {

/// Angle wrapped to [-pi, pi). [rad]
double wrap_angle(double angle);

/// A planar rigid transform `T_a_b`: the pose of frame b in frame a. REP-103: x forward, y left.
struct SE2 {
  double x = 0.0;    ///< [m]
  double y = 0.0;    ///< [m]
  double yaw = 0.0;  ///< [rad] Counter-clockwise; results of the operators lie in [-pi, pi).

  /// Translation part. [m]
  [[nodiscard]] Eigen::Vector2d translation() const { return {x, y}; }
  /// `T_b_a` of `T_a_b`.
  [[nodiscard]] SE2 inverse() const;
  bool operator==(const SE2&) const = default;
};

/// Composition: `T_a_c = T_a_b * T_b_c`.
SE2 operator*(const SE2& T_a_b, const SE2& T_b_c);
/// Coordinates in a of a point given in b: `p_a = T_a_b * p_b`.
Eigen::Vector2d operator*(const SE2& T_a_b, const Eigen::Vector2d& p_b);

/// Distance between the origins. [m]
double distance(const SE2& a, const SE2& b);
/// Absolute difference of the yaws, in [0, pi]. [rad]
double yaw_distance(const SE2& a, const SE2& b);

/// A pose and its uncertainty.
struct PoseWithCovariance {
  SE2 T_map_base;
  /// Of (x, y, yaw) in map: m^2, m rad, rad^2.
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  /// [m] Height of base, on a 3-D map: the nearest ground counts. None: the lowest ground.
  std::optional<double> z{};
};

}  // namespace castaway::localization

namespace castaway {

using Pose2 = localization::SE2;
using localization::distance;
using localization::PoseWithCovariance;
using localization::wrap_angle;
using localization::yaw_distance;

}  // namespace castaway
