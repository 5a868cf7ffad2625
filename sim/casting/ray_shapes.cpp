#include "sim/casting/ray_shapes.hpp"

#include <algorithm>
#include <cmath>

namespace castaway::sim {
namespace {

/// Interval of a ray inside of a shape: [enter, leave]; empty if enter > leave.
struct Span {
  double enter = -kNoHit;
  double leave = kNoHit;
};

constexpr Span kEmpty{kNoHit, -kNoHit};

Span common(const Span& a, const Span& b) {
  return {std::max(a.enter, b.enter), std::min(a.leave, b.leave)};
}

double entry(const Span& span) {
  return span.enter > span.leave || span.leave < 0.0 ? kNoHit : std::max(span.enter, 0.0);
}

/// Interval between the planes -half and +half of one axis.
Span slab(double origin, double direction, double half) {
  if (direction == 0.0) return std::abs(origin) <= half ? Span{} : kEmpty;
  const double inverse = 1.0 / direction;
  const double t1 = (-half - origin) * inverse;
  const double t2 = (half - origin) * inverse;
  return {std::min(t1, t2), std::max(t1, t2)};
}

/// Interval with |o + t d| <= radius, in as many dimensions as the vectors have.
template <typename Vector>
Span ball(const Vector& o, const Vector& d, double radius) {
  const double a = d.squaredNorm();
  const double c = o.squaredNorm() - radius * radius;
  if (a == 0.0) return c <= 0.0 ? Span{} : kEmpty;
  const double b = o.dot(d);
  // The line's distance from the centre is computed first: far away, b^2 - a c would cancel.
  const double discriminant = radius * radius * a - (o * a - d * b).squaredNorm() / a;
  if (discriminant < 0.0) return kEmpty;
  const double root = std::sqrt(discriminant);
  return {(-b - root) / a, (-b + root) / a};
}

Span cylinder(const Ray& ray, double radius, double half_height) {
  const Eigen::Vector2d o = ray.origin.head<2>();
  const Eigen::Vector2d d = ray.direction.head<2>();
  return common(ball(o, d, radius), slab(ray.origin.z(), ray.direction.z(), half_height));
}

double hit(const RayBox& box, const Ray& ray) {
  Span span;
  for (int axis = 0; axis < 3; ++axis) {
    span = common(span, slab(ray.origin[axis], ray.direction[axis], box.half_size[axis]));
  }
  return entry(span);
}

double hit(const RayCylinder& shape, const Ray& ray) {
  return entry(cylinder(ray, shape.radius, shape.half_height));
}

double hit(const RaySphere& sphere, const Ray& ray) {
  return entry(ball(ray.origin, ray.direction, sphere.radius));
}

double hit(const RayCapsule& capsule, const Ray& ray) {
  const Eigen::Vector3d top(0.0, 0.0, capsule.half_height);
  const Eigen::Vector3d above = ray.origin - top;
  const Eigen::Vector3d below = ray.origin + top;
  return std::min({entry(cylinder(ray, capsule.radius, capsule.half_height)),
                   entry(ball(above, ray.direction, capsule.radius)),
                   entry(ball(below, ray.direction, capsule.radius))});
}

/// Source: Moller and Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", 1997.
double hit(const RayTriangle& triangle, const Ray& ray) {
  const Eigen::Vector3d e1 = triangle.b - triangle.a;
  const Eigen::Vector3d e2 = triangle.c - triangle.a;
  const Eigen::Vector3d p = ray.direction.cross(e2);
  const double determinant = e1.dot(p);
  if (determinant == 0.0) return kNoHit;
  const Eigen::Vector3d s = ray.origin - triangle.a;
  const double u = s.dot(p) / determinant;
  if (u < 0.0 || u > 1.0) return kNoHit;
  const Eigen::Vector3d q = s.cross(e1);
  const double v = ray.direction.dot(q) / determinant;
  if (v < 0.0 || u + v > 1.0) return kNoHit;
  const double t = e2.dot(q) / determinant;
  return t < 0.0 ? kNoHit : t;
}

Eigen::Vector3d half_extent(const RayBox& box) { return box.half_size; }
Eigen::Vector3d half_extent(const RayCylinder& c) { return {c.radius, c.radius, c.half_height}; }
Eigen::Vector3d half_extent(const RaySphere& s) { return Eigen::Vector3d::Constant(s.radius); }
Eigen::Vector3d half_extent(const RayCapsule& c) {
  return {c.radius, c.radius, c.half_height + c.radius};
}

template <typename Shape>
Eigen::AlignedBox3d shape_bounds(const Shape& shape, const Eigen::Isometry3d& T) {
  const Eigen::Vector3d half = T.linear().cwiseAbs() * half_extent(shape);
  return {T.translation() - half, T.translation() + half};
}

Eigen::AlignedBox3d shape_bounds(const RayTriangle& triangle, const Eigen::Isometry3d& T) {
  Eigen::AlignedBox3d box(Eigen::Vector3d(T * triangle.a));
  box.extend(Eigen::Vector3d(T * triangle.b));
  box.extend(Eigen::Vector3d(T * triangle.c));
  return box;
}

Eigen::AlignedBox3d shape_bounds(const RaySphere& sphere, const Eigen::Isometry3d& T) {
  const Eigen::Vector3d half = half_extent(sphere);
  return {T.translation() - half, T.translation() + half};
}

}  // namespace

double intersect(const RayShape& shape, const Ray& ray) {
  return std::visit([&ray](const auto& s) { return hit(s, ray); }, shape);
}

double intersect(const RayPrimitive& primitive, const Ray& ray) {
  const auto R = primitive.T_map_shape.linear();
  const Eigen::Vector3d from_center = ray.origin - primitive.T_map_shape.translation();
  return intersect(primitive.shape,
                   Ray{R.transpose() * from_center, R.transpose() * ray.direction});
}

Eigen::AlignedBox3d bounds(const RayPrimitive& primitive) {
  return std::visit([&](const auto& s) { return shape_bounds(s, primitive.T_map_shape); },
                    primitive.shape);
}

}  // namespace castaway::sim
