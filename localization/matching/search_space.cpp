#include "localization/matching/search_space.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "localization/map/cell_index.hpp"

namespace castaway::localization {

double yaw_of_step(int step, int steps) { return 2.0 * std::numbers::pi * step / steps; }

SearchSpace search_space(const GridFrame& frame, int yaw_steps,
                         const std::optional<MatchWindow>& window) {
  SearchSpace space;
  space.high = {frame.width - 1, frame.height - 1};
  if (window) {
    const Eigen::Vector2d centre = frame.T_map_grid.inverse() * window->centre.translation();
    space.low = space.low.cwiseMax(frame.cell_of(centre.array() - window->radius));
    space.high = space.high.cwiseMin(frame.cell_of(centre.array() + window->radius));
  }
  for (int k = 0; k < yaw_steps; ++k) {
    const double yaw_map = yaw_of_step(k, yaw_steps) + frame.T_map_grid.yaw;
    if (window && std::abs(wrap_angle(yaw_map - window->centre.yaw)) > window->yaw_radius) continue;
    space.yaws.push_back(k);
  }
  return space;
}

std::vector<CellOffset> rotate_scan(const ScanPoints& points, int count, double resolution,
                                    double yaw_grid, int reach) {
  const double c = std::cos(yaw_grid) / resolution;
  const double s = std::sin(yaw_grid) / resolution;
  std::vector<CellOffset> offsets;
  offsets.reserve(static_cast<std::size_t>(count));
  for (const std::size_t i : even_indices(points.size(), count)) {
    const double px = points.x[i];
    const double py = points.y[i];
    const int dx = cell_index(0.5 + c * px - s * py);
    const int dy = cell_index(0.5 + s * px + c * py);
    if (std::max(std::abs(dx), std::abs(dy)) < reach) offsets.push_back({dx, dy});
  }
  return offsets;
}

}  // namespace castaway::localization
