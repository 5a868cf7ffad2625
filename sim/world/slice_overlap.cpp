#include <algorithm>
#include <array>
#include <cmath>

#include "sim/world/slice.hpp"

namespace castaway::sim {
namespace {

/// Extent of points along a direction.
struct Extent {
  double min = 0.0;
  double max = 0.0;
};

template <typename Points>
Extent extent_along(const Points& points, const Eigen::Vector2d& direction) {
  Extent extent{points.front().dot(direction), points.front().dot(direction)};
  for (const Eigen::Vector2d& p : points) {
    extent.min = std::min(extent.min, p.dot(direction));
    extent.max = std::max(extent.max, p.dot(direction));
  }
  return extent;
}

std::array<Eigen::Vector2d, 4> corners(const Eigen::AlignedBox2d& r) {
  return {r.min(), Eigen::Vector2d(r.max().x(), r.min().y()), r.max(),
          Eigen::Vector2d(r.min().x(), r.max().y())};
}

/// Separating axis test of convex points and a rectangle; the rectangle's own axes are covered by
/// the test of the bounds.
bool touches_convex(const std::vector<Eigen::Vector2d>& points,
                    const Eigen::AlignedBox2d& rectangle) {
  const auto rectangle_corners = corners(rectangle);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector2d edge = points[(i + 1) % points.size()] - points[i];
    const Eigen::Vector2d normal(-edge.y(), edge.x());
    const Extent a = extent_along(points, normal);
    const Extent b = extent_along(rectangle_corners, normal);
    if (a.max < b.min || b.max < a.min) return false;
  }
  return true;
}

}  // namespace

bool touches(const ConvexOutline& outline, const Eigen::AlignedBox2d& rectangle) {
  return bounds(outline).intersects(rectangle) && touches_convex(outline.points, rectangle);
}

bool touches(const Disc& disc, const Eigen::AlignedBox2d& rectangle) {
  return rectangle.squaredExteriorDistance(disc.center) <= disc.radius * disc.radius;
}

bool touches(const Segment& segment, const Eigen::AlignedBox2d& rectangle) {
  return bounds(segment).intersects(rectangle) && touches_convex({segment.a, segment.b}, rectangle);
}

Eigen::AlignedBox2d bounds(const ConvexOutline& outline) {
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& p : outline.points) box.extend(p);
  return box;
}

Eigen::AlignedBox2d bounds(const Disc& disc) {
  const Eigen::Vector2d half = Eigen::Vector2d::Constant(disc.radius);
  return {disc.center - half, disc.center + half};
}

Eigen::AlignedBox2d bounds(const Segment& segment) {
  Eigen::AlignedBox2d box(segment.a);
  box.extend(segment.b);
  return box;
}

}  // namespace castaway::sim
