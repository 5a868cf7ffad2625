#include "sim/navigation/planner.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <queue>

#include "sim/navigation/level_planner.hpp"

namespace castaway::sim {
namespace {

/// A step to one of the eight neighbours of a cell, or none; a byte, since large maps have millions
/// of cells.
using StepIndex = std::uint8_t;
constexpr StepIndex kStay = 4;
constexpr StepIndex step_index(int dx, int dy) {
  return static_cast<StepIndex>(3 * (dy + 1) + dx + 1);
}

constexpr float kUnreached = std::numeric_limits<float>::infinity();

/// A cell on the frontier; ordered by estimated cost, then by cell.
struct OpenCell {
  float estimate = 0.0F;
  std::uint32_t cell = 0;
  bool operator>(const OpenCell& other) const {
    return estimate != other.estimate ? estimate > other.estimate : cell > other.cell;
  }
};

}  // namespace

double path_price(const FreeSpace& free, std::size_t cell, const PlannerConfig& config) {
  const double room = free.clearance()[cell] - free.radius();
  const double lack = std::clamp(1.0 - room / config.comfort, 0.0, 1.0);
  return 1.0 + config.comfort_weight * lack * lack;
}

namespace {

class AStar {
 public:
  AStar(const FreeSpace& free, CellIndex goal, const PlannerConfig& config)
      : free_(free),
        grid_(free.grid()),
        goal_(goal),
        config_(config),
        cost_(grid_.cells.size(), kUnreached),
        came_by_(grid_.cells.size(), kStay) {}

  bool run(CellIndex start) {
    reach(start, kStay, 0.0F);
    while (!open_.empty()) {
      const OpenCell best = open_.top();
      open_.pop();
      const CellIndex cell = cell_of_index(best.cell);
      if (cell == goal_) return true;
      // A better path has been found since.
      if (best.estimate > cost_[best.cell] + heuristic(cell)) continue;
      expand(cell, best.cell);
    }
    return false;
  }

  [[nodiscard]] std::vector<Eigen::Vector2d> path() const {
    std::vector<Eigen::Vector2d> points;
    CellIndex cell = goal_;
    StepIndex step = kStay;
    do {
      points.push_back(center_of(grid_, cell));
      step = came_by_[flat_index(grid_, cell)];
      cell = {cell.column - (step % 3 - 1), cell.row - (step / 3 - 1)};
    } while (step != kStay);
    std::reverse(points.begin(), points.end());
    return points;
  }

 private:
  /// As `cell_at_index`; a division of 64 bits takes longer than all else on the frontier.
  [[nodiscard]] CellIndex cell_of_index(std::uint32_t index) const {
    const auto width = static_cast<std::uint32_t>(grid_.width);
    return {static_cast<int>(index % width), static_cast<int>(index / width)};
  }
  /// Octile distance: the cost on an empty grid.
  [[nodiscard]] float heuristic(CellIndex c) const {
    const double dx = std::abs(c.column - goal_.column);
    const double dy = std::abs(c.row - goal_.row);
    return static_cast<float>(grid_.resolution *
                              (std::max(dx, dy) + (std::sqrt(2.0) - 1.0) * std::min(dx, dy)));
  }
  void expand(CellIndex from, std::size_t from_index) {
    std::array<bool, 9> free{};  // By step.
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        free[step_index(dx, dy)] = grid_.is_free(from.column + dx, from.row + dy);
      }
    }
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const bool side_free = free[step_index(dx, 0)] && free[step_index(0, dy)];
        if ((dx == 0 && dy == 0) || !free[step_index(dx, dy)] || !side_free) continue;
        step(from, from_index, dx, dy);
      }
    }
  }
  void step(CellIndex from, std::size_t from_index, int dx, int dy) {
    const CellIndex to{from.column + dx, from.row + dy};
    const std::size_t i = flat_index(grid_, to);
    const double length = grid_.resolution * (dx != 0 && dy != 0 ? std::numbers::sqrt2 : 1.0);
    const double least = cost_[from_index] + length;  // No price is below 1.
    if (static_cast<float>(least) >= cost_[i]) return;
    const double cost = cost_[from_index] + length * path_price(free_, i, config_);
    reach(to, step_index(dx, dy), static_cast<float>(cost));
  }
  void reach(CellIndex cell, StepIndex by, float cost) {
    const std::size_t i = flat_index(grid_, cell);
    if (cost >= cost_[i]) return;
    cost_[i] = cost;
    came_by_[i] = by;
    open_.push({cost + heuristic(cell), static_cast<std::uint32_t>(i)});
  }

  const FreeSpace& free_;
  const Grid& grid_;
  CellIndex goal_;
  PlannerConfig config_;
  std::vector<float> cost_;
  std::vector<StepIndex> came_by_;  ///< The step into each cell.
  std::priority_queue<OpenCell, std::vector<OpenCell>, std::greater<>> open_;
};

}  // namespace

std::optional<std::vector<Eigen::Vector2d>> plan_path(const FreeSpace& free,
                                                      const Eigen::Vector2d& start,
                                                      const Eigen::Vector2d& goal,
                                                      const PlannerConfig& config) {
  if (free.levels() != nullptr) return plan_on_levels(free, start, goal, config);
  const std::optional<CellIndex> from = free.nearest_free(start);
  const std::optional<CellIndex> to = free.nearest_free(goal);
  if (!from || !to) return std::nullopt;
  AStar search(free, *to, config);
  if (!search.run(*from)) return std::nullopt;
  return search.path();
}

}  // namespace castaway::sim
