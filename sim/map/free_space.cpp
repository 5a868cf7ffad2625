#include "sim/map/free_space.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

#include <Eigen/Geometry>
#include <boost/random/uniform_int_distribution.hpp>
#include <boost/random/uniform_real_distribution.hpp>

#include "sim/common/cell_index.hpp"
#include "sim/map/level_plane.hpp"

namespace castaway::sim {
namespace {

std::size_t count_row(const Grid& grid, int row) {
  const auto begin = grid.cells.begin() + static_cast<std::ptrdiff_t>(flat_index(grid, {0, row}));
  return static_cast<std::size_t>(std::count(begin, begin + grid.width, Cell::kFree));
}

std::vector<std::size_t> count_rows(const Grid& grid) {
  std::vector<std::size_t> counts;
  for (int row = 0; row < grid.height; ++row) counts.push_back(count_row(grid, row));
  return counts;
}

/// Cells whose centres are at least a distance away from a point.
class FarCells {
 public:
  FarCells(const Grid& grid, const Eigen::Vector2d& from, double reach)
      : grid_(grid),
        from_(from),
        reach_(reach),
        cells_(Eigen::Rotation2Dd(-grid.origin_yaw) * (from - grid.origin) / grid.resolution),
        squared_(reach * reach / (grid.resolution * grid.resolution)) {}

  [[nodiscard]] bool has(CellIndex cell) const {
    const double over = squared_offset(cell.column, cells_.x()) + row_over(cell.row);
    if (std::abs(over) > near()) return over > 0.0;
    return (center_of(grid_, cell) - from_).norm() >= reach_;
  }
  /// True if all cells of a row certainly are.
  [[nodiscard]] bool has_row(int row) const { return reach_ <= 0.0 || row_over(row) > near(); }

 private:
  static double squared_offset(int cell, double from) {
    const double offset = cell + 0.5 - from;
    return offset * offset;
  }
  /// By how much the nearest point of a row's line is farther away. [cells^2]
  [[nodiscard]] double row_over(int row) const {
    return squared_offset(row, cells_.y()) - squared_;
  }
  /// Closer ones need the exact distance. [cells^2]
  [[nodiscard]] double near() const { return 1e-6 * (1.0 + squared_); }

  const Grid& grid_;
  Eigen::Vector2d from_;   ///< [m]
  double reach_;           ///< [m]
  Eigen::Vector2d cells_;  ///< The point in cells.
  double squared_;         ///< The distance in squared cells.
};

}  // namespace

FreeSpace::FreeSpace(const Grid& grid, double radius) : radius_(radius) {
  std::vector<float> clearance = distance_to_obstacle(grid);
  Grid free = largest_component(erode(grid, clearance, radius));
  *this = FreeSpace(radius, std::move(clearance), std::move(free));
}

FreeSpace FreeSpace::around(const Grid& grid, double radius, const Eigen::Vector2d& p_map) {
  std::vector<float> clearance = distance_to_obstacle(grid);
  Grid free = component_at(erode(grid, clearance, radius), p_map);
  return {radius, std::move(clearance), std::move(free)};
}

FreeSpace FreeSpace::whole(const Grid& grid, double radius) {
  std::vector<float> clearance = distance_to_obstacle(grid);
  Grid free = erode(grid, clearance, radius);
  return {radius, std::move(clearance), std::move(free)};
}

FreeSpace FreeSpace::on_levels(std::shared_ptr<const LevelPlane> plane, double radius) {
  std::vector<float> clearance = distance_to_obstacle(plane->grid);
  Grid free = largest_part(*plane, erode(plane->grid, clearance, radius));
  FreeSpace space(radius, std::move(clearance), std::move(free));
  space.levels_ = std::move(plane);
  return space;
}

FreeSpace::FreeSpace(double radius, std::vector<float> clearance, Grid grid) : radius_(radius) {
  std::vector<std::size_t> free_in_row = count_rows(grid);
  parts_ = std::make_shared<const Parts>(
      Parts{std::move(clearance), std::move(grid), std::move(free_in_row)});
}

FreeSpace FreeSpace::with_discs(std::span<const RoundObstacle> discs) const {
  std::vector<float> clearance = parts_->clearance;
  Grid grid = parts_->grid;
  const double reach = radius_ + 0.5 * grid.resolution;
  for (int row = 0; row < grid.height; ++row) {
    for (int column = 0; column < grid.width; ++column) {
      const std::size_t i = flat_index(grid, {column, row});
      if (grid.cells[i] != Cell::kFree) continue;
      const Eigen::Vector2d p = center_of(grid, {column, row});
      for (const RoundObstacle& disc : discs) {
        const double squared = (p - disc.center).squaredNorm();
        const double matters = clearance[i] + disc.radius;
        if (squared >= matters * matters) continue;
        const double gap = std::max(std::sqrt(squared) - disc.radius, 0.0);
        clearance[i] = static_cast<float>(gap);
        if (gap < reach) grid.cells[i] = Cell::kOccupied;
      }
    }
  }
  if (!levels_) return {radius_, std::move(clearance), largest_component(grid)};
  FreeSpace space(radius_, std::move(clearance), largest_part(*levels_, std::move(grid)));
  space.levels_ = levels_;
  return space;
}

bool FreeSpace::contains(const Eigen::Vector2d& p_map) const {
  return levels_ ? free_cell(p_map).has_value() : cell_at(grid(), p_map) == Cell::kFree;
}

std::optional<CellIndex> FreeSpace::free_cell(const Eigen::Vector2d& p_map) const {
  CellIndex cell = cell_of(grid(), p_map);
  if (!grid().contains(cell.column, cell.row)) return std::nullopt;
  if (levels_) {
    const std::int32_t own = levels_->cells[flat_index(grid(), cell)].own;
    if (own < 0) return std::nullopt;
    cell = cell_at_index(grid(), static_cast<std::size_t>(own));
  }
  return grid().is_free(cell.column, cell.row) ? std::optional(cell) : std::nullopt;
}

double FreeSpace::clearance_at(const Eigen::Vector2d& p_map) const {
  const CellIndex cell = cell_of(grid(), p_map);
  return grid().contains(cell.column, cell.row) ? parts_->clearance[flat_index(grid(), cell)] : 0.0;
}

bool FreeSpace::contains_segment(const Eigen::Vector2d& a, const Eigen::Vector2d& b) const {
  const double step = 0.5 * grid().resolution;
  const int steps = cell_index(std::ceil((b - a).norm() / step));
  for (int i = 0; i <= steps; ++i) {
    if (!contains(a + (b - a) * (static_cast<double>(i) / std::max(steps, 1)))) return false;
  }
  return true;
}

std::optional<CellIndex> FreeSpace::nearest_free(const Eigen::Vector2d& p_map) const {
  if (const auto cell = free_cell(p_map)) return cell;
  std::optional<CellIndex> best;
  double best_distance = std::numeric_limits<double>::infinity();
  for (int row = 0; row < grid().height; ++row) {
    for (int column = 0; column < grid().width; ++column) {
      if (grid().at(column, row) != Cell::kFree) continue;
      const double distance = (center_of(grid(), {column, row}) - p_map).squaredNorm();
      if (distance >= best_distance) continue;
      best_distance = distance;
      best = CellIndex{column, row};
    }
  }
  return best;
}

std::optional<CellIndex> FreeSpace::sample_cell(Rng& rng, const Eigen::Vector2d& from,
                                                double reach) const {
  const Grid& grid = parts_->grid;
  const FarCells far(grid, from, reach);
  const auto has = [&](CellIndex cell) {
    return grid.at(cell.column, cell.row) == Cell::kFree && (reach <= 0.0 || far.has(cell));
  };
  // Cells are counted, not listed: a list takes gigabytes for a large map.
  std::vector<std::size_t> in_row = parts_->free_in_row;
  for (int row = 0; row < grid.height; ++row) {
    if (far.has_row(row)) continue;
    std::size_t& count = in_row[static_cast<std::size_t>(row)] = 0;
    for (int column = 0; column < grid.width; ++column) count += has({column, row}) ? 1 : 0;
  }
  const std::size_t count = std::accumulate(in_row.begin(), in_row.end(), std::size_t{0});
  if (count == 0) return std::nullopt;
  std::size_t left = boost::random::uniform_int_distribution<std::size_t>(0, count - 1)(rng);
  CellIndex cell;
  for (; left >= in_row[static_cast<std::size_t>(cell.row)]; ++cell.row) {
    left -= in_row[static_cast<std::size_t>(cell.row)];
  }
  while (!has(cell) || left-- > 0) ++cell.column;
  return cell;
}

std::optional<Pose2> FreeSpace::sample(Rng& rng, const Eigen::Vector2d& from,
                                       double min_distance) const {
  // A draw within a cell must stay outside of the distance.
  const Grid& grid = parts_->grid;
  const double reach = min_distance <= 0.0 ? 0.0 : min_distance + grid.resolution;
  const auto cell = sample_cell(rng, from, reach);
  if (!cell) return std::nullopt;
  boost::random::uniform_real_distribution<double> within(-0.499, 0.499);
  const double dx = within(rng) * grid.resolution;
  const double dy = within(rng) * grid.resolution;
  const double yaw =
      boost::random::uniform_real_distribution<double>(-std::numbers::pi, std::numbers::pi)(rng);
  const Pose2 T_map_cell{center_of(grid, *cell).x(), center_of(grid, *cell).y(), grid.origin_yaw};
  const Eigen::Vector2d p = T_map_cell * Eigen::Vector2d(dx, dy);
  return Pose2{p.x(), p.y(), yaw};
}

std::optional<Pose2> FreeSpace::sample(Rng& rng) const {
  return sample(rng, Eigen::Vector2d::Zero(), 0.0);
}

}  // namespace castaway::sim
