/// Planar rigid transforms: what the localizers need of them besides castaway/pose.hpp.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "castaway/pose.hpp"

namespace castaway::localization {

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

/// The planar pose lifted to 3-D: z, roll and pitch are 0.
Eigen::Isometry3d to_se3(const SE2& T_a_b);

}  // namespace castaway::localization
