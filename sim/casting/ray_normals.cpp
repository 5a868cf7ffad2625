#include "sim/casting/ray_normals.hpp"

#include <algorithm>
#include <cmath>

namespace castaway::sim {
namespace {

constexpr double kSkin = 1e-6;  // [m] A ray continues this far behind a surface.

/// Unit vector along the axis in which `p`, in half sizes, is farthest out.
Eigen::Vector3d main_axis(const Eigen::Vector3d& p) {
  Eigen::Index axis = 0;
  p.cwiseAbs().maxCoeff(&axis);
  return std::copysign(1.0, p[axis]) * Eigen::Vector3d::Unit(axis);
}

Eigen::Vector3d normal(const RayBox& box, const Eigen::Vector3d& p) {
  return main_axis(p.cwiseQuotient(box.half_size));
}

Eigen::Vector3d normal(const RayCylinder& cylinder, const Eigen::Vector3d& p) {
  const double side = p.head<2>().norm() / cylinder.radius;
  const double end = std::abs(p.z()) / cylinder.half_height;
  if (end > side) return std::copysign(1.0, p.z()) * Eigen::Vector3d::UnitZ();
  return Eigen::Vector3d(p.x(), p.y(), 0.0).normalized();
}

Eigen::Vector3d normal(const RaySphere&, const Eigen::Vector3d& p) { return p.normalized(); }

Eigen::Vector3d normal(const RayCapsule& capsule, const Eigen::Vector3d& p) {
  const double z = std::clamp(p.z(), -capsule.half_height, capsule.half_height);
  return (p - Eigen::Vector3d(0.0, 0.0, z)).normalized();
}

Eigen::Vector3d normal(const RayTriangle& t, const Eigen::Vector3d&) {
  return (t.b - t.a).cross(t.c - t.a).normalized();
}

double cosine(const Eigen::Vector3d& normal, const Ray& ray) {
  return std::min(std::abs(normal.dot(ray.direction)), 1.0);
}

}  // namespace

Eigen::Vector3d normal_at(const RayPrimitive& primitive, const Eigen::Vector3d& p_map) {
  const auto R = primitive.T_map_shape.linear();
  const Eigen::Vector3d p = R.transpose() * (p_map - primitive.T_map_shape.translation());
  return R * std::visit([&p](const auto& shape) { return normal(shape, p); }, primitive.shape);
}

Eigen::Vector3d normal_at(const UprightPart& part, const Eigen::Vector3d& p_map) {
  const Eigen::Vector2d axis_y(-part.axis_x.y(), part.axis_x.x());
  const Eigen::Vector2d from_center = p_map.head<2>() - part.center;
  const double x = from_center.dot(part.axis_x) / part.half_size.x();
  const double y = from_center.dot(axis_y) / part.half_size.y();
  if (x * x + y * y < 1.0 - 1e-9) return Eigen::Vector3d::UnitZ();  // Top or bottom.
  const Eigen::Vector2d out =
      (x / part.half_size.x() * part.axis_x + y / part.half_size.y() * axis_y).normalized();
  return {out.x(), out.y(), 0.0};
}

double incidence_cosine(const RayPrimitive& primitive, const Ray& ray, double distance) {
  return cosine(normal_at(primitive, ray.origin + distance * ray.direction), ray);
}

double incidence_cosine(const MovingScene& scene, int object, const Ray& ray) {
  double nearest = kNoHit;
  double result = 1.0;
  for (const MovingBody& body : scene.bodies()) {
    if (body.object != object) continue;
    for (std::size_t i = 0; i < body.count; ++i) {
      const double distance = intersect(body.parts[i], ray);
      if (distance >= nearest) continue;
      nearest = distance;
      result = cosine(normal_at(body.parts[i], ray.origin + distance * ray.direction), ray);
    }
  }
  return result;
}

double exit_distance(const RayPrimitive& primitive, const Ray& ray, double enter) {
  if (std::holds_alternative<RayTriangle>(primitive.shape)) return enter + kSkin;
  const double beyond = enter + 2.0 * bounds(primitive).sizes().norm() + 1.0;
  const Ray back{ray.origin + beyond * ray.direction, -ray.direction};
  const double distance = intersect(primitive, back);
  return (distance == kNoHit ? enter : beyond - distance) + kSkin;
}

}  // namespace castaway::sim
