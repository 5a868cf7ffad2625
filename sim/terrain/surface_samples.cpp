#include "sim/terrain/surface_samples.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

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

void sample_object(const WorldObject& object, double spacing, const PointVisitor& visit) {
  constexpr double kUnderFloor = -1e-6;  // [m]
  const TriangleMesh mesh = shape_mesh(object.shape);
  const auto corner = [&](std::size_t i) -> Eigen::Vector3d {
    return object.T_map_object * mesh.vertices[mesh.indices[i]].cast<double>();
  };
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    sample_triangle({corner(i), corner(i + 1), corner(i + 2)}, spacing,
                    [&](const Eigen::Vector3d& p) {
                      if (p.z() > kUnderFloor) visit(p);
                    });
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

void sample_surfaces(const WorldSpec& world, double spacing, const PointVisitor& visit) {
  const Eigen::Vector2d size = world.max_corner - world.min_corner;
  if (!(size.minCoeff() > 0.0)) throw std::invalid_argument("the world has no extent");
  const int rows = pieces(size.y(), spacing);
  const int columns = pieces(size.x(), spacing);
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const Eigen::Vector2d share((column + 0.5) / columns, (row + 0.5) / rows);
      const Eigen::Vector2d p = world.min_corner + share.cwiseProduct(size);
      visit({p.x(), p.y(), 0.0});
    }
  }
  for (const WorldObject& object : world.objects) {
    if (object.in_map) sample_object(object, spacing, visit);
  }
}

}  // namespace castaway::sim
