#include "sim/robot/urdf/part_points.hpp"

#include <cmath>
#include <numbers>

#include "sim/world/mesh.hpp"

namespace castaway::sim {
namespace {

constexpr int kCirclePoints = 24;
constexpr int kSphereRings = 7;

void add_ring_points(double radius, double z, std::vector<Eigen::Vector3d>& points) {
  for (int i = 0; i < kCirclePoints; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kCirclePoints;
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
  }
}

std::vector<Eigen::Vector3d> local_points(const BoxShape& box) { return box_corners(box); }

std::vector<Eigen::Vector3d> local_points(const CylinderShape& cylinder) {
  std::vector<Eigen::Vector3d> points;
  add_ring_points(cylinder.radius, -0.5 * cylinder.height, points);
  add_ring_points(cylinder.radius, 0.5 * cylinder.height, points);
  return points;
}

std::vector<Eigen::Vector3d> local_points(const SphereShape& sphere) {
  std::vector<Eigen::Vector3d> points{{0.0, 0.0, sphere.radius}, {0.0, 0.0, -sphere.radius}};
  for (int ring = 1; ring <= kSphereRings; ++ring) {
    const double polar = std::numbers::pi * ring / (kSphereRings + 1);
    add_ring_points(sphere.radius * std::sin(polar), sphere.radius * std::cos(polar), points);
  }
  return points;
}

std::vector<Eigen::Vector3d> local_points(const MeshShape& shape) {
  std::vector<Eigen::Vector3d> points;
  for (const Eigen::Vector3f& v : load_mesh(shape.path, shape.scale).vertices) {
    points.emplace_back(v.cast<double>());
  }
  return points;
}

}  // namespace

std::vector<Eigen::Vector3d> part_points(const RobotPart& part) {
  auto points = std::visit([](const auto& shape) { return local_points(shape); }, part.shape);
  for (Eigen::Vector3d& p : points) p = part.T_base_part * p;
  return points;
}

}  // namespace castaway::sim
