#include "sim/world/footprint.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "sim/common/convex_hull.hpp"
#include "sim/world/mesh.hpp"
#include "sim/world/ramp.hpp"

namespace castaway::sim {
namespace {

using Points = std::vector<Eigen::Vector3d>;

constexpr int kSides = 24;
constexpr double kSamePoint = 1e-18;  // [m^2] Squared length below which an edge has no direction.

/// Adds a polygon around a circle.
void add_ring(double radius, double z, Points& points) {
  const double around = radius / std::cos(std::numbers::pi / kSides);
  for (int i = 0; i < kSides; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kSides;
    points.emplace_back(around * std::cos(angle), around * std::sin(angle), z);
  }
}

Points corners(const BoxShape& box) { return box_corners(box); }

Points corners(const CylinderShape& cylinder) {
  Points points;
  add_ring(cylinder.radius, -0.5 * cylinder.height, points);
  add_ring(cylinder.radius, 0.5 * cylinder.height, points);
  return points;
}

Points corners(const SphereShape& sphere) {
  Points points{{0.0, 0.0, -sphere.radius}, {0.0, 0.0, sphere.radius}};
  add_ring(sphere.radius, 0.0, points);
  return points;
}

Points corners(const RampShape& ramp) {
  const RampCorners p = ramp_corners(ramp);
  return {p.low[0], p.low[1], p.right[0], p.right[1], p.left[0], p.left[1]};
}

Points corners(const MeshShape& mesh) {
  Points points;
  for (const Eigen::Vector3f& v : load_mesh(mesh.path, mesh.scale).vertices) {
    points.emplace_back(v.cast<double>());
  }
  return points;
}

Points corners(const WorldObject& object) {
  Points points = std::visit([](const auto& shape) { return corners(shape); }, object.shape);
  for (Eigen::Vector3d& p : points) p = object.T_map_object * p;
  return points;
}

/// True if an edge of `a` separates the two outlines.
bool parted_by_edges(const ConvexOutline& a, const ConvexOutline& b) {
  for (std::size_t i = 0; i < a.points.size(); ++i) {
    const Eigen::Vector2d edge = a.points[(i + 1) % a.points.size()] - a.points[i];
    if (edge.squaredNorm() < kSamePoint) continue;
    const Eigen::Vector2d outward(edge.y(), -edge.x());
    const double reach = outward.dot(a.points[i]);
    if (std::all_of(b.points.begin(), b.points.end(),
                    [&](const Eigen::Vector2d& p) { return outward.dot(p) > reach; })) {
      return true;
    }
  }
  return false;
}

double distance_to_segment(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                           const Eigen::Vector2d& p) {
  const Eigen::Vector2d along = b - a;
  const double length = along.squaredNorm();
  const double t = length > 0.0 ? std::clamp((p - a).dot(along) / length, 0.0, 1.0) : 0.0;
  return (a + t * along - p).norm();
}

}  // namespace

ConvexOutline footprint(const WorldObject& object) {
  std::vector<Eigen::Vector2d> points;
  for (const Eigen::Vector3d& p : corners(object)) points.emplace_back(p.head<2>());
  return {convex_hull(std::move(points))};
}

Eigen::AlignedBox3d bounds(const WorldObject& object) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : corners(object)) box.extend(p);
  return box;
}

ConvexOutline transform_outline(const ConvexOutline& outline, const Eigen::Vector2d& center,
                                double yaw, const Eigen::Vector2d& by) {
  const Eigen::Rotation2Dd turn(yaw);
  ConvexOutline result;
  for (const Eigen::Vector2d& p : outline.points) {
    result.points.emplace_back(center + turn * (p - center) + by);
  }
  return result;
}

bool overlap(const ConvexOutline& a, const ConvexOutline& b) {
  return !parted_by_edges(a, b) && !parted_by_edges(b, a);
}

double distance(const ConvexOutline& outline, const Eigen::Vector2d& p) {
  double nearest = std::numeric_limits<double>::infinity();
  bool inside = true;
  for (std::size_t i = 0; i < outline.points.size(); ++i) {
    const Eigen::Vector2d& a = outline.points[i];
    const Eigen::Vector2d& b = outline.points[(i + 1) % outline.points.size()];
    nearest = std::min(nearest, distance_to_segment(a, b, p));
    inside = inside && (b.x() - a.x()) * (p.y() - a.y()) >= (b.y() - a.y()) * (p.x() - a.x());
  }
  return inside ? 0.0 : nearest;
}

}  // namespace castaway::sim
