#include "sim/navigation/level_planner.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <queue>

#include "sim/map/level_plane.hpp"

namespace castaway::sim {
namespace {

constexpr double kBehindChart = 1.0;  // [m] A path goes on for so long behind its chart.
constexpr std::uint32_t kNoCell = std::numeric_limits<std::uint32_t>::max();

/// A* over own cells; a step into another chart's margin leads to the cell that it stands for.
class LevelSearch {
 public:
  LevelSearch(const FreeSpace& free, std::size_t goal, const PlannerConfig& config)
      : free_(free),
        plane_(*free.levels()),
        grid_(free.grid()),
        goal_(goal),
        goal_at_(cell_at_index(grid_, goal)),
        config_(config),
        cost_(grid_.cells.size(), std::numeric_limits<float>::infinity()),
        from_(grid_.cells.size(), kNoCell) {}

  bool run(std::size_t start) {
    reach(start, kNoCell, 0.0);
    while (!open_.empty()) {
      const auto [estimate, index] = open_.top();
      open_.pop();
      if (index == goal_) return true;
      if (estimate <= cost_[index] + heuristic(index)) expand(index);
    }
    return false;
  }

  /// Cells from the start to the goal.
  [[nodiscard]] std::vector<std::size_t> path() const {
    std::vector<std::size_t> cells;
    for (auto cell = static_cast<std::uint32_t>(goal_); cell != kNoCell; cell = from_[cell]) {
      cells.push_back(cell);
    }
    std::reverse(cells.begin(), cells.end());
    return cells;
  }

 private:
  using Open = std::pair<float, std::uint32_t>;

  /// The way as seen from above, as the crow flies. [m]
  [[nodiscard]] float heuristic(std::size_t cell) const {
    const CellIndex a = cell_at_index(grid_, cell);
    const float dx = static_cast<float>(a.column - goal_at_.column);
    const float dy = static_cast<float>(a.row % plane_.stride - goal_at_.row % plane_.stride);
    return static_cast<float>(grid_.resolution) * std::sqrt(dx * dx + dy * dy);
  }

  /// The free cell that a step leads to; `kNoCell` if there is none.
  [[nodiscard]] std::uint32_t own(CellIndex cell) const {
    if (!grid_.contains(cell.column, cell.row)) return kNoCell;
    const std::int32_t own = plane_.cells[flat_index(grid_, cell)].own;
    const bool free = own >= 0 && grid_.cells[static_cast<std::size_t>(own)] == Cell::kFree;
    return free ? static_cast<std::uint32_t>(own) : kNoCell;
  }

  void expand(std::uint32_t from) {
    const CellIndex cell = cell_at_index(grid_, from);
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const std::uint32_t to = own({cell.column + dx, cell.row + dy});
        const bool sides = own({cell.column + dx, cell.row}) != kNoCell &&
                           own({cell.column, cell.row + dy}) != kNoCell;
        if ((dx == 0 && dy == 0) || to == kNoCell || !sides) continue;
        const double length = grid_.resolution * (dx != 0 && dy != 0 ? std::numbers::sqrt2 : 1.0);
        reach(to, from, cost_[from] + length * path_price(free_, to, config_));
      }
    }
  }

  void reach(std::size_t cell, std::uint32_t from, double cost) {
    if (static_cast<float>(cost) >= cost_[cell]) return;
    cost_[cell] = static_cast<float>(cost);
    from_[cell] = from;
    open_.push({cost_[cell] + heuristic(cell), static_cast<std::uint32_t>(cell)});
  }

  const FreeSpace& free_;
  const LevelPlane& plane_;
  const Grid& grid_;
  std::size_t goal_;
  CellIndex goal_at_;
  PlannerConfig config_;
  std::vector<float> cost_;
  std::vector<std::uint32_t> from_;
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open_;
};

std::optional<std::vector<std::size_t>> cells_between(const FreeSpace& free,
                                                      const Eigen::Vector2d& start,
                                                      const Eigen::Vector2d& goal,
                                                      const PlannerConfig& config) {
  const std::optional<CellIndex> from = free.nearest_free(start);
  const std::optional<CellIndex> to = free.nearest_free(goal);
  if (!from || !to) return std::nullopt;
  LevelSearch search(free, flat_index(free.grid(), *to), config);
  if (!search.run(flat_index(free.grid(), *from))) return std::nullopt;
  return search.path();
}

}  // namespace

std::optional<std::vector<Eigen::Vector2d>> plan_on_levels(const FreeSpace& free,
                                                           const Eigen::Vector2d& start,
                                                           const Eigen::Vector2d& goal,
                                                           const PlannerConfig& config) {
  const auto cells = cells_between(free, start, goal, config);
  if (!cells) return std::nullopt;
  const LevelPlane& plane = *free.levels();
  const Grid& grid = free.grid();
  const int chart = cell_at_index(grid, cells->front()).row / plane.stride;
  std::vector<Eigen::Vector2d> points;
  double behind = 0.0;
  for (const std::size_t cell : *cells) {
    const CellIndex at = cell_at_index(grid, cell);
    const int rows = (chart - at.row / plane.stride) * plane.stride;
    points.push_back(center_of(grid, {at.column, at.row + rows}));
    if (points.size() > 1 && rows != 0) behind += (points.back() - *(points.end() - 2)).norm();
    if (behind > kBehindChart) break;
  }
  return points;
}

std::optional<std::vector<Eigen::Vector3d>> plan_over_levels(const FreeSpace& free,
                                                             const Eigen::Vector2d& start,
                                                             const Eigen::Vector2d& goal,
                                                             const PlannerConfig& config) {
  const auto cells = cells_between(free, start, goal, config);
  if (!cells) return std::nullopt;
  std::vector<Eigen::Vector3d> points;
  for (const std::size_t cell : *cells) {
    points.push_back(
        free.levels()->p_map(center_of(free.grid(), cell_at_index(free.grid(), cell))));
  }
  return points;
}

}  // namespace castaway::sim
