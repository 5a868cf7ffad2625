#include "sim/map/surface_samples.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sim/casting/ray_normals.hpp"
#include "sim/casting/ray_scene.hpp"
#include "sim/world/world_visuals.hpp"

namespace castaway::sim {
namespace {

int pieces(double length, double spacing) {
  return std::max(1, static_cast<int>(std::ceil(length / spacing)));
}

/// Turns the corners so that the longest edge leads from the first to the second one.
void put_longest_first(std::array<Eigen::Vector3d, 3>& corners) {
  std::array<double, 3> lengths{};
  for (std::size_t i = 0; i < 3; ++i) lengths[i] = (corners[(i + 1) % 3] - corners[i]).norm();
  const auto longest = std::max_element(lengths.begin(), lengths.end()) - lengths.begin();
  std::rotate(corners.begin(), corners.begin() + longest, corners.end());
}

/// The objects of a world's map, as solids that hide what is in them.
class Solids {
 public:
  explicit Solids(const WorldSpec& world) : scene_(ray_primitives(on_map(world))) {}

  /// True if nothing can see a surface: it is in a solid or faces into the floor, or the first
  /// surface above it shows its back. `normal`: of the surface, away from its object.
  [[nodiscard]] bool hide(const Eigen::Vector3d& p_map, const Eigen::Vector3d& normal) const {
    constexpr double kOff = 1e-4;  // [m]
    constexpr double kSky = 1e4;   // [m]
    const Ray up{p_map + kOff * normal, Eigen::Vector3d::UnitZ()};
    if (up.origin.z() < 0.0) return true;
    const auto hit = scene_.cast(up, kSky);
    if (!hit) return false;
    if (hit->distance == 0.0) return true;
    const RayPrimitive& primitive = scene_.primitives()[hit->primitive];
    if (!std::holds_alternative<RayTriangle>(primitive.shape)) return false;
    return normal_at(primitive, up.origin + hit->distance * up.direction).z() > 0.0;
  }

 private:
  static WorldSpec on_map(WorldSpec world) {
    std::erase_if(world.objects, [](const WorldObject& object) { return !object.in_map; });
    for (WorldObject& object : world.objects) object.in_world = true;
    return world;
  }

  RayScene scene_;
};

/// A point of a surface and the direction away from its object.
struct SurfaceSample {
  Eigen::Vector3d p;
  Eigen::Vector3d normal;
};

/// Moves a sample in the object's frame from a facet of the mesh to the round surface that it
/// stands for: facets lie within.
SurfaceSample round_off(const ObjectShape& shape, const SurfaceSample& sample) {
  const auto& [p, normal] = sample;
  if (const auto* ball = std::get_if<SphereShape>(&shape)) {
    return {ball->radius * p.normalized(), p.normalized()};
  }
  const auto* cylinder = std::get_if<CylinderShape>(&shape);
  if (cylinder == nullptr || std::abs(normal.z()) > 0.5) return sample;
  const Eigen::Vector2d out = p.head<2>().normalized();
  const Eigen::Vector2d side = cylinder->radius * out;
  return {{side.x(), side.y(), p.z()}, {out.x(), out.y(), 0.0}};
}

void sample_object(const WorldObject& object, const Solids& solids, double spacing,
                   const SurfaceVisitor& visit) {
  constexpr double kUnderFloor = -1e-6;  // [m]
  const TriangleMesh mesh = shape_mesh(object.shape);
  const auto corner = [&](std::size_t i) -> Eigen::Vector3d {
    return mesh.vertices[mesh.indices[i]].cast<double>();
  };
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const std::array<Eigen::Vector3d, 3> corners{corner(i), corner(i + 1), corner(i + 2)};
    const Eigen::Vector3d normal =
        (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
    sample_triangle(corners, spacing, [&](const Eigen::Vector3d& p_object) {
      const SurfaceSample sample = round_off(object.shape, {p_object, normal});
      const Eigen::Vector3d p_map = object.T_map_object * sample.p;
      const Eigen::Vector3d normal_map = object.T_map_object.linear() * sample.normal;
      if (p_map.z() > kUnderFloor && !solids.hide(p_map, normal_map)) visit(p_map, normal_map);
    });
  }
}

void sample_floor(const WorldSpec& world, const Solids& solids, double spacing,
                  const SurfaceVisitor& visit) {
  const Eigen::Vector2d size = world.max_corner - world.min_corner;
  const int rows = pieces(size.y(), spacing);
  const int columns = pieces(size.x(), spacing);
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const Eigen::Vector2d share((column + 0.5) / columns, (row + 0.5) / rows);
      const Eigen::Vector2d p = world.min_corner + share.cwiseProduct(size);
      const Eigen::Vector3d p_map(p.x(), p.y(), 0.0);
      if (!solids.hide(p_map, Eigen::Vector3d::UnitZ())) visit(p_map, Eigen::Vector3d::UnitZ());
    }
  }
}

}  // namespace

void sample_triangle(std::array<Eigen::Vector3d, 3> corners, double spacing,
                     const PointVisitor& visit) {
  put_longest_first(corners);
  const auto& [a, b, c] = corners;
  const double base = (b - a).norm();
  const double twice_area = (b - a).cross(c - a).norm();
  if (!(twice_area > 0.0)) return;
  const int rows = pieces(twice_area / base, spacing);
  for (int row = 0; row < rows; ++row) {
    const double s = (row + 0.5) / rows;
    const Eigen::Vector3d from = a + s * (c - a);
    const Eigen::Vector3d to = b + s * (c - b);
    const int columns = pieces((1.0 - s) * base, spacing);
    for (int column = 0; column < columns; ++column) {
      visit(from + (column + 0.5) / columns * (to - from));
    }
  }
}

void sample_surfaces(const WorldSpec& world, double spacing, const SurfaceVisitor& visit) {
  if (!((world.max_corner - world.min_corner).minCoeff() > 0.0)) {
    throw std::invalid_argument("the world has no extent");
  }
  const Solids solids(world);
  sample_floor(world, solids, spacing, visit);
  for (const WorldObject& object : world.objects) {
    if (object.in_map) sample_object(object, solids, spacing, visit);
  }
}

}  // namespace castaway::sim
