/// Shortest paths from everywhere to a few places.
///
/// People share their goals: one search from each place (Dijkstra) serves everybody who goes there,
/// and following a path costs nothing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "sim/common/random.hpp"
#include "sim/people/walk_cells.hpp"

namespace castaway::sim {

/// Places to go to and the paths there, away from corners.
class GoalFields {
 public:
  /// Draws `places` places from the cells, which must outlive this. @throws std::runtime_error if
  /// there is no room to walk.
  GoalFields(const WalkCells& cells, int places, Rng& rng);

  /// The same places on other cells, which must outlive this: the world changed. People who cannot
  /// get to a place any more stay where they are.
  void set_cells(const WalkCells& cells);

  [[nodiscard]] const std::vector<Eigen::Vector2d>& places() const { return places_; }
  /// Returns the point to walk to from `p_map` on the way to a place: at most about 1.4 m ahead on
  /// the path, and reachable in a straight line. The first call for a place runs its search.
  [[nodiscard]] Eigen::Vector2d ahead(std::size_t place, const Eigen::Vector2d& p_map);

 private:
  using Index = WalkCells::Index;
  using StepIndex = std::uint8_t;  ///< A byte: large maps have millions of cells.
  struct Frontier;

  /// The step to take on the way to `goal`, by cell.
  [[nodiscard]] std::vector<StepIndex> search(Index goal) const;
  void spread(Index cell, Frontier& frontier, std::vector<StepIndex>& next) const;

  const WalkCells* cells_;
  std::vector<Eigen::Vector2d> places_;
  std::vector<std::vector<StepIndex>> next_;  ///< By place and cell; empty before the search.
};

}  // namespace castaway::sim
