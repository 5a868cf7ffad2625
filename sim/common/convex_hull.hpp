/// Convex hull of points in the plane: A. M. Andrew, "Another Efficient Algorithm for Convex Hulls
/// in Two Dimensions", Information Processing Letters 9(5), 1979.
#pragma once

#include <vector>

#include <Eigen/Core>

namespace castaway::sim {

/// z of the cross product: positive if b lies counter-clockwise of a.
inline double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Convex hull, counter-clockwise, without points on its edges. Fewer than three points are
/// returned as they are.
std::vector<Eigen::Vector2d> convex_hull(std::vector<Eigen::Vector2d> points);

}  // namespace castaway::sim
