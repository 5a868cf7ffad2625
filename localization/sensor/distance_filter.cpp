#include "localization/sensor/distance_filter.hpp"

#include <cmath>
#include <cstddef>
#include <vector>

#include "localization/sensor/pose_in_cells.hpp"

namespace castaway::localization {

bool DistanceFilter::fits(const ScanPoints& points, const SE2& T_map_base) const {
  const auto off =
      std::visit([&](const auto* map) { return misfits(*map, points, T_map_base); }, world_);
  return static_cast<double>(off) < config_.misfits * static_cast<double>(points.size());
}

/// Number of end points off the walls.
std::size_t DistanceFilter::misfits(const WallClearance& walls, const ScanPoints& points,
                                    const SE2& T_map_base) const {
  const GridFrame& frame = walls.frame();
  const PoseInCells pose(frame, T_map_base);
  const double off_wall = 2.0 * config_.off_wall / frame.resolution;  // [half cells]
  std::size_t count = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const int column = static_cast<int>(std::floor(pose.x(points.x[i], points.y[i])));
    const int row = static_cast<int>(std::floor(pose.y(points.x[i], points.y[i])));
    const bool on_map = frame.contains({column, row});
    if (!on_map || walls.half_cells(column, row) > off_wall) ++count;
  }
  return count;
}

std::size_t DistanceFilter::misfits(const Volume& volume, const ScanPoints& points,
                                    const SE2& T_map_base) const {
  const auto there = volume.lift(T_map_base);
  if (!there) return points.size();
  const PoseInVolume pose(there->T_map_base);
  const auto off_wall = static_cast<float>(config_.off_wall);
  std::size_t count = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (volume.surfaces().at(pose.end(points, i)) > off_wall) ++count;
  }
  return count;
}

ScanPoints DistanceFilter::expected(const ScanPoints& points, const SE2& T_map_base) const {
  if (points.empty() || fits(points, T_map_base)) return points;
  const RayConsistency rays(world_, T_map_base, {});
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!rays.ends_before_wall(points, i, config_.before_wall)) kept.push_back(i);
  }
  if (kept.size() < static_cast<std::size_t>(config_.least)) return points;
  return points_at(points, kept);
}

}  // namespace castaway::localization
