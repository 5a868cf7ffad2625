#include "sim/world/slice.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "sim/common/convex_hull.hpp"
#include "sim/world/mesh.hpp"
#include "sim/world/ramp.hpp"

namespace castaway::sim {
namespace {

constexpr int kPrismSides = 64;

/// Adds the point where the edge from a to b crosses the height, if it does.
void add_crossing(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double z,
                  std::vector<Eigen::Vector2d>& points) {
  if ((a.z() - z) * (b.z() - z) > 0.0) return;
  if (a.z() == b.z()) {
    points.emplace_back(a.head<2>());
    points.emplace_back(b.head<2>());
    return;
  }
  const double fraction = (z - a.z()) / (b.z() - a.z());
  points.emplace_back((a + fraction * (b - a)).head<2>());
}

/// Cut of a convex prism with corners `low[i]`, `high[i]`.
Slice cut_prism(const std::vector<Eigen::Vector3d>& low, const std::vector<Eigen::Vector3d>& high,
                double z) {
  std::vector<Eigen::Vector2d> points;
  for (std::size_t i = 0; i < low.size(); ++i) {
    const std::size_t next = (i + 1) % low.size();
    add_crossing(low[i], high[i], z, points);
    add_crossing(low[i], low[next], z, points);
    add_crossing(high[i], high[next], z, points);
  }
  Slice result;
  if (points.size() >= 3) result.outlines.push_back({convex_hull(std::move(points))});
  return result;
}

Slice cut(const BoxShape& box, const Eigen::Isometry3d& T, double z) {
  const Eigen::Vector3d h = 0.5 * box.size;
  std::vector<Eigen::Vector3d> low;
  std::vector<Eigen::Vector3d> high;
  for (const auto& [x, y] : {std::pair{h.x(), h.y()}, std::pair{-h.x(), h.y()},
                             std::pair{-h.x(), -h.y()}, std::pair{h.x(), -h.y()}}) {
    low.emplace_back(T * Eigen::Vector3d(x, y, -h.z()));
    high.emplace_back(T * Eigen::Vector3d(x, y, h.z()));
  }
  return cut_prism(low, high, z);
}

Slice cut(const CylinderShape& cylinder, const Eigen::Isometry3d& T, double z) {
  const double half = 0.5 * cylinder.height;
  if (std::abs(T.linear()(2, 2)) > 1.0 - 1e-12) {
    Slice result;
    if (std::abs(z - T.translation().z()) <= half) {
      result.discs.push_back({T.translation().head<2>(), cylinder.radius});
    }
    return result;
  }
  std::vector<Eigen::Vector3d> low;
  std::vector<Eigen::Vector3d> high;
  for (int i = 0; i < kPrismSides; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kPrismSides;
    const Eigen::Vector3d rim(cylinder.radius * std::cos(angle), cylinder.radius * std::sin(angle),
                              0.0);
    low.emplace_back(T * (rim - half * Eigen::Vector3d::UnitZ()));
    high.emplace_back(T * (rim + half * Eigen::Vector3d::UnitZ()));
  }
  return cut_prism(low, high, z);
}

Slice cut(const SphereShape& sphere, const Eigen::Isometry3d& T, double z) {
  const double height = z - T.translation().z();
  Slice result;
  if (std::abs(height) <= sphere.radius) {
    const double radius = std::sqrt(sphere.radius * sphere.radius - height * height);
    result.discs.push_back({T.translation().head<2>(), radius});
  }
  return result;
}

Slice cut(const RampShape& ramp, const Eigen::Isometry3d& T, double z) {
  const RampCorners p = ramp_corners(ramp);
  return cut_prism({T * p.low[0], T * p.right[0], T * p.right[1]},
                   {T * p.low[1], T * p.left[0], T * p.left[1]}, z);
}

Slice cut(const TriangleMesh& mesh, const Eigen::Isometry3d& T, double z) {
  const auto vertex = [&](std::size_t i) -> Eigen::Vector3d {
    return T * mesh.vertices[mesh.indices[i]].cast<double>();
  };
  Slice result;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    std::vector<Eigen::Vector2d> points;
    for (std::size_t edge = 0; edge < 3; ++edge) {
      add_crossing(vertex(i + edge), vertex(i + (edge + 1) % 3), z, points);
    }
    for (std::size_t p = 1; p < points.size(); ++p) {
      result.segments.push_back({points[p - 1], points[p]});
    }
  }
  return result;
}

/// The shape to cut; a mesh is read once for all heights.
template <typename Shape>
const Shape& solid_of(const Shape& shape) {
  return shape;
}
TriangleMesh solid_of(const MeshShape& shape) { return load_mesh(shape.path, shape.scale); }

}  // namespace

std::vector<Slice> slices(const WorldObject& object, const std::vector<double>& heights) {
  return std::visit(
      [&](const auto& shape) {
        const auto& solid = solid_of(shape);
        std::vector<Slice> result;
        for (const double z : heights) result.push_back(cut(solid, object.T_map_object, z));
        return result;
      },
      object.shape);
}

Slice slice(const WorldObject& object, double z) { return slices(object, {z}).front(); }

}  // namespace castaway::sim
