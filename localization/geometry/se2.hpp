/// Planar rigid transforms.
#pragma once

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

/// A transform prepared for many points: sine and cosine are computed once.
class PlaneTransform {
 public:
  explicit PlaneTransform(const SE2& T_a_b);
  /// To the bit that of `SE2`.
  Eigen::Vector2d operator*(const Eigen::Vector2d& p_b) const {
    return {x_ + cos_ * p_b.x() - sin_ * p_b.y(), y_ + sin_ * p_b.x() + cos_ * p_b.y()};
  }

 private:
  double x_, y_;
  double cos_, sin_;
};

/// Interpolates from `a` (fraction 0) to `b` (1), and extrapolates beyond: linear in position, the
/// shorter way in yaw.
SE2 interpolate(const SE2& a, const SE2& b, double fraction);

/// Distance between the origins. [m]
double distance(const SE2& a, const SE2& b);
/// Absolute difference of the yaws, in [0, pi]. [rad]
double yaw_distance(const SE2& a, const SE2& b);

/// The planar pose lifted to 3-D: z, roll and pitch are 0.
Eigen::Isometry3d to_se3(const SE2& T_a_b);

}  // namespace castaway::localization
