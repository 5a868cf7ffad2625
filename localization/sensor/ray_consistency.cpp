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

bool meets_wall(const CellRay& ray, const DistanceField& distances) {
  const GridFrame& frame = distances.frame();
  const auto scale = static_cast<float>(1.0 / frame.resolution);
  const float* values = distances.values().data();
  const auto width = static_cast<float>(frame.width);
  const auto height = static_cast<float>(frame.height);
  bool inside = true;  // Still inside of the object in which the ray starts.
  for (float t = 0.0F; t < ray.length;) {
    const float x = ray.from.x() + t * ray.direction.x();
    const float y = ray.from.y() + t * ray.direction.y();
    if (!(x >= 0.0F && y >= 0.0F && x < width && y < height)) return false;
    const float d = values[static_cast<int>(y) * frame.width + static_cast<int>(x)] * scale;
    if (d >= 0.5F) inside = false;
    if (d < 0.5F && !inside) return true;
    t += std::max(d - 1.0F, 0.5F);
  }
  return false;
}

}  // namespace

RayConsistency::RayConsistency(const DistanceField& distances, const SE2& T_map_base,
                               const RayConsistencyConfig& config)
    : distances_(distances), config_(config), pose_(distances.frame(), T_map_base) {}

bool RayConsistency::through_wall(const ScanPoints& points, std::size_t i) const {
  const auto scale = static_cast<float>(1.0 / distances_.frame().resolution);
  const float r = points.range[i];
  const float margin =
      std::max(static_cast<float>(config_.margin), static_cast<float>(config_.margin_share) * r);
  if (r <= margin) return false;
  const Eigen::Vector2f from(pose_.x(points.origin_x[i], points.origin_y[i]),
                             pose_.y(points.origin_x[i], points.origin_y[i]));
  const Eigen::Vector2f to(pose_.x(points.x[i], points.y[i]), pose_.y(points.x[i], points.y[i]));
  return meets_wall({from, (to - from) / (r * scale), (r - margin) * scale}, distances_);
}

}  // namespace castaway::localization
