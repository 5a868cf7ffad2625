#include "localization/sensor/ray_consistency.hpp"

#include <algorithm>

#include "localization/sensor/pose_in_cells.hpp"

namespace castaway::localization {
namespace {

/// Distances in cells; a ray of length `length` from `from` along the unit vector `direction`.
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
  bool inside = true;  // of what the ray begins in
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

std::vector<bool> beams_through_walls(const ScanPoints& points, const DistanceField& distances,
                                      const SE2& T_map_base, const RayConsistencyConfig& config) {
  const GridFrame& frame = distances.frame();
  const PoseInCells pose(frame, T_map_base);
  const auto scale = static_cast<float>(1.0 / frame.resolution);
  std::vector<bool> through(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const float r = points.range[i];
    const float margin =
        std::max(static_cast<float>(config.margin), static_cast<float>(config.margin_share) * r);
    if (r <= margin) continue;
    const Eigen::Vector2f from(pose.x(points.origin_x[i], points.origin_y[i]),
                               pose.y(points.origin_x[i], points.origin_y[i]));
    const Eigen::Vector2f to(pose.x(points.x[i], points.y[i]), pose.y(points.x[i], points.y[i]));
    through[i] = meets_wall({from, (to - from) / (r * scale), (r - margin) * scale}, distances);
  }
  return through;
}

}  // namespace castaway::localization
