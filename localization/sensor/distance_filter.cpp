#include "localization/sensor/distance_filter.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numeric>
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
  for (std::size_t i = 0; i < points.size(); i += 4) {
    const FourPoints p_map = pose * four_ends(points, i);
    const FourInts off = volume.surfaces().at(p_map.x, p_map.y, p_map.z) > off_wall;
    const int last = static_cast<int>(std::min<std::size_t>(4, points.size() - i));
    for (int k = 0; k < last; ++k) count += off[k] != 0 ? 1U : 0U;
  }
  return count;
}

ScanPoints DistanceFilter::expected(const ScanPoints& points, const SE2& T_map_base) const {
  if (points.empty() || fits(points, T_map_base)) return points;
  const RayConsistency rays(world_, T_map_base, {});
  std::vector<std::size_t> all(points.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  const std::vector<std::size_t> before = rays.ends_before_wall(points, all, config_.before_wall);
  std::vector<std::size_t> kept;
  std::ranges::set_difference(all, before, std::back_inserter(kept));
  if (kept.size() < static_cast<std::size_t>(config_.least)) return points;
  return points_at(points, kept);
}

}  // namespace castaway::localization
