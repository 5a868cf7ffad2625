#include "sim/people/goal_fields.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

#include <boost/random/uniform_int_distribution.hpp>

#include "sim/map/grid_tools.hpp"

namespace castaway::sim {
namespace {

constexpr std::uint32_t kNowhere = std::numeric_limits<std::uint32_t>::max();
constexpr double kComfort = 0.5;  // [m] Wanted distance from the middle of the body to walls.
// Extra cost of a metre right beside a wall; a metre in the open costs 1.
constexpr double kComfortWeight = 3.0;
// [cells] Path points tried as the next target, farthest first.
constexpr std::array<int, 4> kLooks = {14, 9, 5, 2};

struct Step {
  int dx;
  int dy;
};
constexpr std::array<Step, 8> kNeighbourSteps = {
    {{-1, -1}, {0, -1}, {1, -1}, {-1, 0}, {1, 0}, {-1, 1}, {0, 1}, {1, 1}}};
constexpr std::uint8_t kNoStep = kNeighbourSteps.size();

/// The step that undoes another.
constexpr std::size_t back(std::size_t step) { return kNeighbourSteps.size() - 1 - step; }

/// Cells of at least `GoalFields::kCell`; free if a person can stand anywhere in them.
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
      if (fine.is_free(column, row)) continue;
      grid.cells[flat_index(grid, {column / factor, row / factor})] = Cell::kOccupied;
    }
  }
  return largest_component(grid);
}

}  // namespace

GoalFields::GoalFields(const WalkSpace& space, int places, Rng& rng)
    : space_(space),
      grid_(coarse(space)),
      cell_axes_(Eigen::Rotation2Dd(grid_.origin_yaw).toRotationMatrix() * grid_.resolution),
      prices_(grid_.cells.size(), 0.0F),
      exits_(grid_.cells.size(), 0),
      next_(static_cast<std::size_t>(places)) {
  std::vector<Index> free;
  for (Index i = 0; i < grid_.cells.size(); ++i) {
    if (grid_.cells[i] != Cell::kFree) continue;
    prices_[i] = price(i);
    exits_[i] = exits(i);
    free.push_back(i);
  }
  if (free.empty()) throw std::runtime_error("people: the world has no room to walk in");
  boost::random::uniform_int_distribution<std::size_t> any(0, free.size() - 1);
  for (int i = 0; i < places; ++i) places_.push_back(center(free[any(rng)]));
}

Eigen::Vector2d GoalFields::center(Index cell) const {
  const auto width = static_cast<Index>(grid_.width);
  const Index row = cell / width;
  return grid_.origin + cell_axes_ * Eigen::Vector2d(cell % width + 0.5, row + 0.5);
}

/// The free cell at a point, or the nearest one within two cells.
GoalFields::Index GoalFields::cell_near(const Eigen::Vector2d& p_map) const {
  const CellIndex at = cell_of(grid_, p_map);
  if (grid_.is_free(at.column, at.row)) return static_cast<Index>(flat_index(grid_, at));
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

/// Bit set of the steps that can be taken from a cell without cutting a corner.
std::uint16_t GoalFields::exits(Index cell) const {
  const int column = static_cast<int>(cell) % grid_.width;
  const int row = static_cast<int>(cell) / grid_.width;
  std::uint16_t result = 0;
  for (std::size_t k = 0; k < kNeighbourSteps.size(); ++k) {
    const auto [dx, dy] = kNeighbourSteps[k];
    const bool clear = grid_.is_free(column + dx, row + dy) && grid_.is_free(column + dx, row) &&
                       grid_.is_free(column, row + dy);
    if (clear) result = static_cast<std::uint16_t>(result | (1U << k));
  }
  return result;
}

/// State of Dijkstra's search, with a bucket for every stretch of cost as long as the shortest
/// step: within a bucket the order does not matter (R. B. Dial, "Algorithm 360: Shortest-Path
/// Forest with Topological Ordering", 1969). A cell is in every bucket in which it was reached.
/// Finished buckets are reused, since every step is shorter than all buckets together.
struct GoalFields::Frontier {
  using Bucket = std::vector<std::pair<float, Index>>;

  void reach(Index cell, float whole) {
    cost[cell] = whole;
    bucket(static_cast<std::size_t>(whole / width)).push_back({whole, cell});
    ++waiting;
  }
  Bucket& bucket(std::size_t number) { return buckets[number % buckets.size()]; }

  float width;
  std::vector<float> cost;
  std::array<Bucket, 8> buckets{};
  std::size_t waiting = 0;  ///< In all buckets.
};
// Buckets that one step can span.
static_assert((1.0 + kComfortWeight) * std::numbers::sqrt2 < 7.0);

GoalFields::Index GoalFields::neighbour(Index cell, std::size_t step) const {
  const auto [dx, dy] = kNeighbourSteps[step];
  return static_cast<Index>(static_cast<int>(cell) + dy * grid_.width + dx);
}

/// Updates the neighbours of a cell.
void GoalFields::spread(Index cell, Frontier& frontier, std::vector<StepIndex>& next) const {
  for (std::size_t k = 0; k < kNeighbourSteps.size(); ++k) {
    if ((exits_[cell] & (1U << k)) == 0) continue;
    const auto [dx, dy] = kNeighbourSteps[k];
    const float length = dx != 0 && dy != 0 ? std::numbers::sqrt2_v<float> : 1.0F;
    const float whole = frontier.cost[cell] + prices_[cell] * length;
    const Index to = neighbour(cell, k);
    if (whole >= frontier.cost[to]) continue;
    next[to] = static_cast<StepIndex>(back(k));
    frontier.reach(to, whole);
  }
}

std::vector<GoalFields::StepIndex> GoalFields::search(Index goal) const {
  constexpr float kUnreached = std::numeric_limits<float>::infinity();
  const std::size_t cells = grid_.cells.size();
  Frontier frontier{static_cast<float>(grid_.resolution), std::vector<float>(cells, kUnreached)};
  std::vector<StepIndex> next(cells, kNoStep);
  frontier.reach(goal, 0.0F);
  for (std::size_t number = 0; frontier.waiting > 0; ++number) {
    Frontier::Bucket& bucket = frontier.bucket(number);
    for (std::size_t i = 0; i < bucket.size(); ++i) {  // The bucket may grow.
      const auto [reached, cell] = bucket[i];
      if (reached == frontier.cost[cell]) spread(cell, frontier, next);
    }
    frontier.waiting -= bucket.size();
    bucket.clear();
  }
  return next;
}

Eigen::Vector2d GoalFields::ahead(std::size_t place, const Eigen::Vector2d& p_map) {
  if (next_[place].empty()) next_[place] = search(cell_near(places_[place]));
  Index cell = cell_near(p_map);
  if (cell == kNowhere) return places_[place];
  std::array<Index, kLooks[0] + 1> path{};
  for (Index& step : path) {
    step = cell;
    const StepIndex next = next_[place][cell];
    if (next != kNoStep) cell = neighbour(cell, next);
  }
  for (const int look : kLooks) {
    Eigen::Vector2d p = center(path[static_cast<std::size_t>(look)]);
    if (space_.clear(p_map, p)) return p;
  }
  return center(path[1]);
}

}  // namespace castaway::sim
