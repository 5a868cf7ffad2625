/// An upright elliptic cylinder, as people consist of for a lidar.
#pragma once

#include <Eigen/Core>

#include "sim/casting/ray_shapes.hpp"

namespace castaway::sim {

/// A solid with the same elliptic horizontal cut from `bottom` to `top`. In map.
struct UprightPart {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();     ///< [m]
  Eigen::Vector2d axis_x = Eigen::Vector2d::UnitX();    ///< Unit vector of `half_size.x()`.
  Eigen::Vector2d half_size = Eigen::Vector2d::Ones();  ///< [m] Semi-axes; equal for a circle.
  double bottom = 0.0;                                  ///< [m] Above the floor.
  double top = 1.0;                                     ///< [m]
};

/// Distance along a ray in map to where it enters the part, kNoHit if it does not; 0 if it starts
/// inside. Exact: the ellipse is scaled to a circle, which keeps distances along the ray.
double intersect(const UprightPart& part, const Ray& ray);

}  // namespace castaway::sim
