#include "sim/casting/moving_scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace castaway::sim {
namespace {

/// A point or direction in map in the part's axes, in units of the semi-axes.
Eigen::Vector2d to_semi_axes(const UprightPart& part, const Eigen::Vector2d& v) {
  const Eigen::Vector2d axis_y(-part.axis_x.y(), part.axis_x.x());
  return {v.dot(part.axis_x) / part.half_size.x(), v.dot(axis_y) / part.half_size.y()};
}

constexpr float kFloatMargin = 1e-3F;  // [m] More than single precision loses within 1 km.
constexpr int kNobody = -1;

/// A disc about the mean centre of all parts that covers them.
std::pair<Eigen::Vector2d, double> cover(const MovingBody& body) {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < body.count; ++i) {
    center += body.parts[i].center / static_cast<double>(body.count);
  }
  double far = 0.0;  // Squared; a slightly too wide disc saves square roots.
  double half_size = 0.0;
  for (std::size_t i = 0; i < body.count; ++i) {
    const UprightPart& part = body.parts[i];
    far = std::max(far, (part.center - center).squaredNorm());
    half_size = std::max(half_size, part.half_size.maxCoeff());
  }
  return {center, std::sqrt(far) + half_size};
}

}  // namespace

double intersect(const UprightPart& part, const Ray& ray) {
  double enter = 0.0;
  double leave = kNoHit;
  const double dz = ray.direction.z();
  if (dz != 0.0) {
    const double t1 = (part.bottom - ray.origin.z()) / dz;
    const double t2 = (part.top - ray.origin.z()) / dz;
    enter = std::max(enter, std::min(t1, t2));
    leave = std::min(leave, std::max(t1, t2));
  } else if (ray.origin.z() < part.bottom || ray.origin.z() > part.top) {
    return kNoHit;
  }
  if (enter > leave) return kNoHit;
  const Eigen::Vector2d o = to_semi_axes(part, ray.origin.head<2>() - part.center);
  const Eigen::Vector2d d = to_semi_axes(part, ray.direction.head<2>());
  const double a = d.squaredNorm();
  if (a > 0.0) {
    // The line's distance from the centre is computed first: far away, b^2 - a c would cancel.
    const double b = o.dot(d);
    const double discriminant = a - (o * a - d * b).squaredNorm() / a;
    if (discriminant < 0.0) return kNoHit;
    const double root = std::sqrt(discriminant);
    enter = std::max(enter, (-b - root) / a);
    leave = std::min(leave, (-b + root) / a);
  } else if (o.squaredNorm() > 1.0) {
    return kNoHit;
  }
  return enter <= leave ? enter : kNoHit;
}

/// A ray prepared for many disc tests.
struct MovingScene::Walk {
  explicit Walk(const Ray& ray)
      : x(static_cast<float>(ray.origin.x())),
        y(static_cast<float>(ray.origin.y())),
        dx(static_cast<float>(ray.direction.x())),
        dy(static_cast<float>(ray.direction.y())),
        level(std::sqrt(dx * dx + dy * dy)) {}

  /// Not negative where the ray may hit a disc before `nearest`. One expression, since temporaries
  /// would cost more than they save.
  [[nodiscard]] Lanes overlap(const Discs& discs, float nearest) const {
    const float limit = nearest * level * level;
    const auto to_x = discs.x - x;
    const auto to_y = discs.y - y;
    const auto along = to_x * dx + to_y * dy;
    return discs.radius * level - (to_y * dx - to_x * dy).abs().max(-along).max(along - limit);
  }

  float x, y, dx, dy;
  float level;  ///< Length of the direction's horizontal part.
};

MovingScene::MovingScene(std::vector<MovingBody> bodies) : bodies_(std::move(bodies)) {
  discs_.resize((bodies_.size() + kWidth - 1) / kWidth);
  for (Discs& discs : discs_) discs = {Lanes::Zero(), Lanes::Zero(), Lanes::Constant(-1.0F)};
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const auto [center, radius] = cover(bodies_[i]);
    Discs& discs = discs_[i / kWidth];
    const auto lane = static_cast<Eigen::Index>(i % kWidth);
    discs.x[lane] = static_cast<float>(center.x());
    discs.y[lane] = static_cast<float>(center.y());
    discs.radius[lane] = static_cast<float>(radius) + kFloatMargin;
  }
}

void MovingScene::visit(const MovingBody& body, const Ray& ray, RayHit& nearest) {
  const double z_begin = ray.origin.z();
  const double z_end = z_begin + std::min(nearest.distance, 1e9) * ray.direction.z();
  const double low = std::min(z_begin, z_end);
  const double high = std::max(z_begin, z_end);
  for (std::size_t i = 0; i < body.count; ++i) {
    if (low > body.parts[i].top || high < body.parts[i].bottom) continue;
    const double distance = intersect(body.parts[i], ray);
    if (distance < nearest.distance) nearest = {distance, body.object, kNoPrimitive};
  }
}

std::optional<RayHit> MovingScene::cast(const Ray& ray, double max_distance) const {
  const Walk walk(ray);
  RayHit nearest{max_distance, kNobody, kNoPrimitive};
  for (std::size_t block = 0; block < discs_.size(); ++block) {
    const float limit = static_cast<float>(std::min(nearest.distance, 1e30)) + kFloatMargin;
    const Lanes overlap = walk.overlap(discs_[block], limit);
    if (overlap.maxCoeff() < 0.0F) continue;
    const std::size_t first = block * kWidth;
    for (std::size_t k = 0; k < kWidth && first + k < bodies_.size(); ++k) {
      if (overlap[static_cast<Eigen::Index>(k)] >= 0.0F) visit(bodies_[first + k], ray, nearest);
    }
  }
  if (nearest.object == kNobody) return std::nullopt;
  return nearest;
}

}  // namespace castaway::sim
