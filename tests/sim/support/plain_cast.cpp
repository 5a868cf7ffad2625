#include "tests/sim/support/plain_cast.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace castaway::sim {
namespace {

using Real = long double;
using Vector = Eigen::Matrix<Real, 3, 1>;

/// A ray in the frame of a shape.
struct Line {
  Vector o;
  Vector d;
  [[nodiscard]] Vector at(Real t) const { return o + t * d; }
};

constexpr Real kNever = std::numeric_limits<Real>::infinity();

/// Smallest t >= 0 of the candidates for which `inside` holds; 0 if the origin is inside.
template <typename Inside>
Real first(const Line& line, const std::vector<Real>& candidates, Inside inside) {
  if (inside(line.o, 0)) return 0;
  Real best = kNever;
  for (const Real t : candidates) {
    if (t >= 0 && t < best && inside(line.at(t), 1e-9L)) best = t;
  }
  return best;
}

void add_roots(Real a, Real b, Real c, std::vector<Real>& t) {
  if (a == 0) return;
  const Real discriminant = b * b - 4 * a * c;
  if (discriminant < 0) return;
  t.push_back((-b - std::sqrt(discriminant)) / (2 * a));
  t.push_back((-b + std::sqrt(discriminant)) / (2 * a));
}

void add_planes(const Line& line, int axis, Real half, std::vector<Real>& t) {
  if (line.d[axis] == 0) return;
  t.push_back((half - line.o[axis]) / line.d[axis]);
  t.push_back((-half - line.o[axis]) / line.d[axis]);
}

Real distance(const RayBox& box, const Line& line) {
  std::vector<Real> t;
  for (int axis = 0; axis < 3; ++axis) add_planes(line, axis, box.half_size[axis], t);
  return first(line, t, [&](const Vector& p, Real margin) {
    return ((p.cwiseAbs() - box.half_size.cast<Real>()).array() <= margin).all();
  });
}

Real distance(const RayCylinder& c, const Line& line) {
  std::vector<Real> t;
  add_planes(line, 2, c.half_height, t);
  const auto o = line.o.head<2>();
  const auto d = line.d.head<2>();
  add_roots(d.squaredNorm(), 2 * o.dot(d), o.squaredNorm() - Real(c.radius) * c.radius, t);
  return first(line, t, [&](const Vector& p, Real margin) {
    return p.head<2>().norm() <= c.radius + margin && std::abs(p.z()) <= c.half_height + margin;
  });
}

Real ball(const Vector& center, Real radius, const Line& line) {
  std::vector<Real> t;
  const Vector o = line.o - center;
  add_roots(line.d.squaredNorm(), 2 * o.dot(line.d), o.squaredNorm() - radius * radius, t);
  return first(line, t, [&](const Vector& p, Real margin) {
    return (p - center).norm() <= radius + margin;
  });
}

Real distance(const RaySphere& s, const Line& line) { return ball(Vector::Zero(), s.radius, line); }

Real distance(const RayCapsule& c, const Line& line) {
  const Vector top(0, 0, c.half_height);
  return std::min({distance(RayCylinder{c.radius, c.half_height}, line), ball(top, c.radius, line),
                   ball(-top, c.radius, line)});
}

Real distance(const RayTriangle& triangle, const Line& line) {
  const Vector a = triangle.a.cast<Real>();
  const Vector b = triangle.b.cast<Real>();
  const Vector c = triangle.c.cast<Real>();
  const Vector normal = (b - a).cross(c - a);
  const Real slope = normal.dot(line.d);
  if (slope == 0) return kNever;
  const Real t = normal.dot(a - line.o) / slope;
  if (t < 0) return kNever;
  const Vector p = line.at(t);
  const std::array<Real, 3> sides = {normal.dot((b - a).cross(p - a)),
                                     normal.dot((c - b).cross(p - b)),
                                     normal.dot((a - c).cross(p - c))};
  const bool in = std::all_of(sides.begin(), sides.end(), [](Real side) { return side >= 0; });
  return in ? t : kNever;
}

}  // namespace

double plain_distance(const RayPrimitive& primitive, const Ray& ray) {
  const auto R = primitive.T_map_shape.linear().cast<Real>();
  const Vector from = (ray.origin - primitive.T_map_shape.translation()).cast<Real>();
  const Line line{R.transpose() * from, R.transpose() * ray.direction.cast<Real>()};
  return static_cast<double>(
      std::visit([&line](const auto& s) { return distance(s, line); }, primitive.shape));
}

double plain_distance(const UprightPart& part, const Ray& ray) {
  const Real angle = std::atan2(Real(part.axis_x.y()), Real(part.axis_x.x()));
  const auto turned = [angle](const Eigen::Vector3d& v) {
    return Vector(std::cos(angle) * v.x() + std::sin(angle) * v.y(),
                  std::cos(angle) * v.y() - std::sin(angle) * v.x(), v.z());
  };
  const Eigen::Vector3d center(part.center.x(), part.center.y(), 0.5 * (part.bottom + part.top));
  const Line line{turned(ray.origin - center), turned(ray.direction)};
  const Real ra = Real(part.half_size.x()) * part.half_size.x();
  const Real rb = Real(part.half_size.y()) * part.half_size.y();
  const Real half = 0.5L * (Real(part.top) - part.bottom);
  std::vector<Real> t;
  add_planes(line, 2, half, t);
  const Vector& o = line.o;
  const Vector& d = line.d;
  add_roots(d.x() * d.x() / ra + d.y() * d.y() / rb, 2 * (o.x() * d.x() / ra + o.y() * d.y() / rb),
            o.x() * o.x() / ra + o.y() * o.y() / rb - 1, t);
  return static_cast<double>(first(line, t, [&](const Vector& p, Real margin) {
    return p.x() * p.x() / ra + p.y() * p.y() / rb <= 1 + margin &&
           std::abs(p.z()) <= half + margin;
  }));
}

double plain_cast(const std::vector<RayPrimitive>& primitives,
                  const std::vector<MovingBody>& bodies, const Ray& ray, double max_distance) {
  double nearest = max_distance;
  for (const RayPrimitive& primitive : primitives) {
    nearest = std::min(nearest, plain_distance(primitive, ray));
  }
  for (const MovingBody& body : bodies) {
    for (std::size_t i = 0; i < body.count; ++i) {
      nearest = std::min(nearest, plain_distance(body.parts[i], ray));
    }
  }
  return nearest < max_distance ? nearest : kNoHit;
}

}  // namespace castaway::sim
