#include "sim/map/free_space.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <boost/random/uniform_int_distribution.hpp>
#include <boost/random/uniform_real_distribution.hpp>

#include "sim/common/cell_index.hpp"

namespace castaway::sim {
namespace {}  // namespace

FreeSpace::FreeSpace(const Grid& grid, double radius)
    : radius_(radius),
      clearance_(distance_to_obstacle(grid)),
      grid_(largest_component(erode(grid, clearance_, radius))) {}

FreeSpace FreeSpace::with_discs(std::span<const RoundObstacle> discs) const {
  FreeSpace result = *this;
  const double reach = radius_ + 0.5 * grid_.resolution;
  for (int row = 0; row < grid_.height; ++row) {
    for (int column = 0; column < grid_.width; ++column) {
      const std::size_t i = flat_index(grid_, {column, row});
      if (grid_.cells[i] != Cell::kFree) continue;
      const Eigen::Vector2d p = center_of(grid_, {column, row});
      for (const RoundObstacle& disc : discs) {
        const double squared = (p - disc.center).squaredNorm();
        const double matters = result.clearance_[i] + disc.radius;
        if (squared >= matters * matters) continue;
        const double gap = std::max(std::sqrt(squared) - disc.radius, 0.0);
        result.clearance_[i] = static_cast<float>(gap);
        if (gap < reach) result.grid_.cells[i] = Cell::kOccupied;
      }
    }
  }
  result.grid_ = largest_component(result.grid_);
  return result;
}

bool FreeSpace::contains(const Eigen::Vector2d& p_map) const {
  return cell_at(grid_, p_map) == Cell::kFree;
}

double FreeSpace::clearance_at(const Eigen::Vector2d& p_map) const {
  const CellIndex cell = cell_of(grid_, p_map);
  return grid_.contains(cell.column, cell.row) ? clearance_[flat_index(grid_, cell)] : 0.0;
}

bool FreeSpace::contains_segment(const Eigen::Vector2d& a, const Eigen::Vector2d& b) const {
  const double step = 0.5 * grid_.resolution;
  const int steps = cell_index(std::ceil((b - a).norm() / step));
  for (int i = 0; i <= steps; ++i) {
    if (!contains(a + (b - a) * (static_cast<double>(i) / std::max(steps, 1)))) return false;
  }
  return true;
}

std::optional<CellIndex> FreeSpace::nearest_free(const Eigen::Vector2d& p_map) const {
  if (contains(p_map)) return cell_of(grid_, p_map);
  std::optional<CellIndex> best;
  double best_distance = std::numeric_limits<double>::infinity();
  for (int row = 0; row < grid_.height; ++row) {
    for (int column = 0; column < grid_.width; ++column) {
      if (grid_.at(column, row) != Cell::kFree) continue;
      const double distance = (center_of(grid_, {column, row}) - p_map).squaredNorm();
      if (distance >= best_distance) continue;
      best_distance = distance;
      best = CellIndex{column, row};
    }
  }
  return best;
}

std::optional<Pose2> FreeSpace::sample(Rng& rng, const Eigen::Vector2d& from,
                                       double min_distance) const {
  // A draw within a cell must stay outside of the distance.
  const double reach = min_distance + grid_.resolution;
  const auto fits = [&](std::size_t i) {
    if (grid_.cells[i] != Cell::kFree) return false;
    return min_distance <= 0.0 ||
           (center_of(grid_, cell_at_index(grid_, i)) - from).norm() >= reach;
  };
  std::size_t count = 0;  // Cells are counted, not listed: a list takes gigabytes for a large map.
  for (std::size_t i = 0; i < grid_.cells.size(); ++i) count += fits(i) ? 1 : 0;
  if (count == 0) return std::nullopt;
  std::size_t left = boost::random::uniform_int_distribution<std::size_t>(0, count - 1)(rng);
  std::size_t drawn = 0;
  while (!fits(drawn) || left-- > 0) ++drawn;
  const CellIndex cell = cell_at_index(grid_, drawn);
  boost::random::uniform_real_distribution<double> within(-0.499, 0.499);
  const double dx = within(rng) * grid_.resolution;
  const double dy = within(rng) * grid_.resolution;
  const double yaw =
      boost::random::uniform_real_distribution<double>(-std::numbers::pi, std::numbers::pi)(rng);
  const Pose2 T_map_cell{center_of(grid_, cell).x(), center_of(grid_, cell).y(), grid_.origin_yaw};
  const Eigen::Vector2d p = T_map_cell * Eigen::Vector2d(dx, dy);
  return Pose2{p.x(), p.y(), yaw};
}

std::optional<Pose2> FreeSpace::sample(Rng& rng) const {
  return sample(rng, Eigen::Vector2d::Zero(), 0.0);
}

}  // namespace castaway::sim
