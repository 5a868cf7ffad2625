#include "localization/sensor/ray_consistency.hpp"

#include <algorithm>

namespace castaway::localization {
namespace {

/// A ray in cells: `length` from `from` along the unit vector `direction`.
struct CellRay {
  Eigen::Vector2f from;
  Eigen::Vector2f direction;
  float length;
};

bool ray_meets_wall(const CellRay& ray, const WallClearance& walls) {
  const GridFrame& frame = walls.frame();
  const auto width = static_cast<float>(frame.width);
  const auto height = static_cast<float>(frame.height);
  bool inside = true;  // Still inside of the object in which the ray starts.
  for (float t = 0.0F; t < ray.length;) {
    const float x = ray.from.x() + t * ray.direction.x();
    const float y = ray.from.y() + t * ray.direction.y();
    if (!(x >= 0.0F && y >= 0.0F && x < width && y < height)) return false;
    const int clear = walls.half_cells(static_cast<int>(x), static_cast<int>(y));
    if (clear == 0 && !inside) return true;
    if (clear > 0) inside = false;
    t += 0.5F * static_cast<float>(std::max(clear - 2, 1));
  }
  return false;
}

}  // namespace

RayConsistency::RayConsistency(const WallClearance& walls, const SE2& T_map_base,
                               const RayConsistencyConfig& config)
    : walls_(walls), config_(config), pose_(walls.frame(), T_map_base) {}

bool RayConsistency::through_wall(const ScanPoints& points, std::size_t i) const {
  const double r = points.range[i];
  const double margin = std::max(config_.margin, config_.margin_share * r);
  return r > margin && meets_wall(points, i, -margin);
}

bool RayConsistency::ends_before_wall(const ScanPoints& points, std::size_t i,
                                      double beyond) const {
  return !meets_wall(points, i, beyond);
}

/// True if beam `i`, made longer by `longer` [m], meets a wall.
bool RayConsistency::meets_wall(const ScanPoints& points, std::size_t i, double longer) const {
  const auto scale = static_cast<float>(1.0 / walls_.frame().resolution);
  const float r = points.range[i];
  const Eigen::Vector2f from(pose_.x(points.origin_x[i], points.origin_y[i]),
                             pose_.y(points.origin_x[i], points.origin_y[i]));
  const Eigen::Vector2f to(pose_.x(points.x[i], points.y[i]), pose_.y(points.x[i], points.y[i]));
  const float length = (r + static_cast<float>(longer)) * scale;
  return ray_meets_wall({from, (to - from) / (r * scale), length}, walls_);
}

}  // namespace castaway::localization
