#include "sim/casting/upright_part.hpp"

#include <algorithm>
#include <cmath>

namespace castaway::sim {
namespace {

/// A point or direction in map in the part's axes, in units of the semi-axes.
Eigen::Vector2d to_semi_axes(const UprightPart& part, const Eigen::Vector2d& v) {
  const Eigen::Vector2d axis_y(-part.axis_x.y(), part.axis_x.x());
  return {v.dot(part.axis_x) / part.half_size.x(), v.dot(axis_y) / part.half_size.y()};
}

}  // namespace

double intersect(const UprightPart& part, const Ray& ray) {
  double enter = 0.0;
  double leave = kNoHit;
  const double dz = ray.direction.z();
  if (dz != 0.0) {
    const double t1 = (part.bottom - ray.origin.z()) / dz;
    const double t2 = (part.top - ray.origin.z()) / dz;
    enter = std::max(enter, std::min(t1, t2));
    leave = std::min(leave, std::max(t1, t2));
  } else if (ray.origin.z() < part.bottom || ray.origin.z() > part.top) {
    return kNoHit;
  }
  if (enter > leave) return kNoHit;
  const Eigen::Vector2d o = to_semi_axes(part, ray.origin.head<2>() - part.center);
  const Eigen::Vector2d d = to_semi_axes(part, ray.direction.head<2>());
  const double a = d.squaredNorm();
  if (a > 0.0) {
    // The line's distance from the centre is computed first: far away, b^2 - a c would cancel.
    const double b = o.dot(d);
    const double discriminant = a - (o * a - d * b).squaredNorm() / a;
    if (discriminant < 0.0) return kNoHit;
    const double root = std::sqrt(discriminant);
    enter = std::max(enter, (-b - root) / a);
    leave = std::min(leave, (-b + root) / a);
  } else if (o.squaredNorm() > 1.0) {
    return kNoHit;
  }
  return enter <= leave ? enter : kNoHit;
}

}  // namespace castaway::sim
