#include "sim/people/goal_fields.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <queue>
#include <stdexcept>

#include <boost/random/uniform_int_distribution.hpp>

#include "sim/world/grid_tools.hpp"

namespace castaway::sim {
namespace {

constexpr std::uint32_t kNowhere = std::numeric_limits<std::uint32_t>::max();
constexpr double kComfort = 0.5;        // [m] Wanted from the middle of the body to walls.
constexpr double kComfortWeight = 3.0;  // Cost of a metre right at the wall, over one far off.
constexpr std::array<int, 4> kLooks = {14, 9, 5, 2};  // [cells] Ahead.

/// Cells of at least `GoalFields::kCell`, free where a person can stand all over them.
Grid coarse(const WalkSpace& space) {
  const Grid& fine = space.free().grid();
  const int factor =
      std::max(1, static_cast<int>(std::lround(GoalFields::kCell / fine.resolution)));
  const auto cells = [factor](int n) { return (n + factor - 1) / factor; };
  Grid grid = make_grid(cells(fine.width), cells(fine.height), factor * fine.resolution,
                        fine.origin, Cell::kFree);
  grid.origin_yaw = fine.origin_yaw;
  for (int row = 0; row < factor * grid.height; ++row) {
    for (int column = 0; column < factor * grid.width; ++column) {
      if (fine.contains(column, row) && fine.at(column, row) == Cell::kFree) continue;
      grid.cells[flat_index(grid, {column / factor, row / factor})] = Cell::kOccupied;
    }
  }
  return largest_component(grid);
}

}  // namespace

GoalFields::GoalFields(const WalkSpace& space, int places, Rng& rng)
    : space_(space), grid_(coarse(space)), next_(static_cast<std::size_t>(places)) {
  std::vector<Index> free;
  for (Index i = 0; i < grid_.cells.size(); ++i) {
    if (grid_.cells[i] == Cell::kFree) free.push_back(i);
  }
  if (free.empty()) throw std::runtime_error("people: the world has no room to walk in");
  boost::random::uniform_int_distribution<std::size_t> any(0, free.size() - 1);
  for (int i = 0; i < places; ++i) places_.push_back(center(free[any(rng)]));
}

Eigen::Vector2d GoalFields::center(Index cell) const {
  const auto width = static_cast<Index>(grid_.width);
  return center_of(grid_, {static_cast<int>(cell % width), static_cast<int>(cell / width)});
}

/// The free cell at a point or, next to it, the nearest one.
GoalFields::Index GoalFields::cell_near(const Eigen::Vector2d& p_map) const {
  const CellIndex at = cell_of(grid_, p_map);
  Index best = kNowhere;
  double best_distance = std::numeric_limits<double>::infinity();
  for (int dy = -2; dy <= 2; ++dy) {
    for (int dx = -2; dx <= 2; ++dx) {
      const CellIndex cell{at.column + dx, at.row + dy};
      if (!grid_.contains(cell.column, cell.row)) continue;
      const auto index = static_cast<Index>(flat_index(grid_, cell));
      if (grid_.cells[index] != Cell::kFree) continue;
      const double distance = (center(index) - p_map).squaredNorm();
      if (distance < best_distance) {
        best_distance = distance;
        best = index;
      }
    }
  }
  return best;
}

float GoalFields::price(Index cell) const {
  const double lack = std::clamp(1.0 - (space_.wall(center(cell)).distance - WalkSpace::kBodyRoom) /
                                           (kComfort - WalkSpace::kBodyRoom),
                                 0.0, 1.0);
  return static_cast<float>(grid_.resolution * (1.0 + kComfortWeight * lack));
}

bool GoalFields::is_free(int column, int row) const {
  return grid_.contains(column, row) && grid_.at(column, row) == Cell::kFree;
}

/// Free cells next to one from which it can be entered without cutting a corner, and whether they
/// lie across.
std::vector<std::pair<GoalFields::Index, bool>> GoalFields::neighbours(Index cell) const {
  const int column = static_cast<int>(cell) % grid_.width;
  const int row = static_cast<int>(cell) / grid_.width;
  std::vector<std::pair<Index, bool>> result;
  for (int k = 0; k < 9; ++k) {
    const int dx = k % 3 - 1;
    const int dy = k / 3 - 1;
    if (k == 4 || !is_free(column + dx, row + dy)) continue;
    if (!is_free(column + dx, row) || !is_free(column, row + dy)) continue;
    const std::size_t to = flat_index(grid_, {column + dx, row + dy});
    result.emplace_back(static_cast<Index>(to), dx != 0 && dy != 0);
  }
  return result;
}

void GoalFields::search(std::size_t place) {
  using Candidate = std::pair<float, Index>;  // Ties by cell.
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> open;
  std::vector<float> cost(grid_.cells.size(), std::numeric_limits<float>::infinity());
  std::vector<Index>& next = next_[place];
  next.assign(grid_.cells.size(), kNowhere);
  const Index goal = cell_near(places_[place]);
  cost[goal] = 0.0F;
  open.push({0.0F, goal});
  while (!open.empty()) {
    const auto [reached, cell] = open.top();
    open.pop();
    if (reached > cost[cell]) continue;
    const float step = price(cell);
    for (const auto& [to, across] : neighbours(cell)) {
      const float whole = reached + step * (across ? std::numbers::sqrt2_v<float> : 1.0F);
      if (whole >= cost[to]) continue;
      cost[to] = whole;
      next[to] = cell;
      open.push({whole, to});
    }
  }
}

Eigen::Vector2d GoalFields::ahead(std::size_t place, const Eigen::Vector2d& p_map) {
  if (next_[place].empty()) search(place);
  Index cell = cell_near(p_map);
  if (cell == kNowhere) return places_[place];
  std::array<Index, kLooks[0] + 1> path{};
  for (Index& step : path) {
    step = cell;
    if (next_[place][cell] != kNowhere) cell = next_[place][cell];
  }
  for (const int look : kLooks) {
    const Eigen::Vector2d p = center(path[static_cast<std::size_t>(look)]);
    if (space_.clear(p_map, p)) return p;
  }
  return center(path[1]);
}

}  // namespace castaway::sim
