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

// [cells] Path points tried as the next target, farthest first.
constexpr std::array<int, 4> kLooks = {14, 9, 5, 2};
constexpr std::uint8_t kNoStep = WalkCells::kSteps;

}  // namespace

GoalFields::GoalFields(const WalkCells& cells, int places, Rng& rng)
    : cells_(&cells), next_(static_cast<std::size_t>(places)) {
  const std::vector<Index>& free = cells.free();
  if (free.empty()) throw std::runtime_error("people: the world has no room to walk in");
  boost::random::uniform_int_distribution<std::size_t> any(0, free.size() - 1);
  for (int i = 0; i < places; ++i) places_.push_back(cells.center(free[any(rng)]));
}

void GoalFields::set_cells(const WalkCells& cells) {
  cells_ = &cells;
  for (std::vector<StepIndex>& next : next_) next.clear();
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
static_assert((1.0 + WalkCells::kComfortWeight) * std::numbers::sqrt2 < 7.0);

/// Updates the neighbours of a cell.
void GoalFields::spread(Index cell, Frontier& frontier, std::vector<StepIndex>& next) const {
  for (std::size_t k = 0; k < WalkCells::kSteps; ++k) {
    if (!cells_->has_exit(cell, k)) continue;
    const float length = WalkCells::is_diagonal(k) ? std::numbers::sqrt2_v<float> : 1.0F;
    const float whole = frontier.cost[cell] + cells_->price(cell) * length;
    const Index to = cells_->neighbour(cell, k);
    if (whole >= frontier.cost[to]) continue;
    next[to] = static_cast<StepIndex>(WalkCells::back(k));
    frontier.reach(to, whole);
  }
}

std::vector<GoalFields::StepIndex> GoalFields::search(Index goal) const {
  constexpr float kUnreached = std::numeric_limits<float>::infinity();
  const std::size_t cells = cells_->grid().cells.size();
  Frontier frontier{static_cast<float>(cells_->grid().resolution),
                    std::vector<float>(cells, kUnreached)};
  std::vector<StepIndex> next(cells, kNoStep);
  if (goal == WalkCells::kNowhere) return next;  // Something was put there.
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
  if (next_[place].empty()) next_[place] = search(cells_->near(places_[place]));
  Index cell = cells_->near(p_map);
  if (cell == WalkCells::kNowhere) return places_[place];
  std::array<Index, kLooks[0] + 1> path{};
  for (Index& step : path) {
    step = cell;
    const StepIndex next = next_[place][cell];
    if (next != kNoStep) cell = cells_->neighbour(cell, next);
  }
  for (const int look : kLooks) {
    Eigen::Vector2d p = cells_->center(path[static_cast<std::size_t>(look)]);
    if (cells_->space().clear(p_map, p)) return p;
  }
  return cells_->center(path[1]);
}

}  // namespace castaway::sim
