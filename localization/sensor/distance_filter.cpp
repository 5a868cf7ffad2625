#include "localization/sensor/distance_filter.hpp"

#include <cmath>
#include <cstddef>
#include <vector>

#include "localization/sensor/pose_in_cells.hpp"
#include "localization/sensor/ray_consistency.hpp"

namespace castaway::localization {

bool DistanceFilter::fits(const ScanPoints& points, const SE2& T_map_base) const {
  const GridFrame& frame = walls_.frame();
  const PoseInCells pose(frame, T_map_base);
  const double off_wall = 2.0 * config_.off_wall / frame.resolution;  // [half cells]
  std::size_t misfits = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const int column = static_cast<int>(std::floor(pose.x(points.x[i], points.y[i])));
    const int row = static_cast<int>(std::floor(pose.y(points.x[i], points.y[i])));
    const bool on_map = frame.contains({column, row});
    if (!on_map || walls_.half_cells(column, row) > off_wall) ++misfits;
  }
  return static_cast<double>(misfits) < config_.misfits * static_cast<double>(points.size());
}

ScanPoints DistanceFilter::expected(const ScanPoints& points, const SE2& T_map_base) const {
  if (points.empty() || fits(points, T_map_base)) return points;
  const RayConsistency rays(walls_, T_map_base, {});
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!rays.ends_before_wall(points, i, config_.before_wall)) kept.push_back(i);
  }
  if (kept.size() < static_cast<std::size_t>(config_.least)) return points;
  return points_at(points, kept);
}

}  // namespace castaway::localization
