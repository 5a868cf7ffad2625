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
#include "sim/people/walk_space.hpp"

namespace castaway::sim {

/// Places to go to and the paths there, on cells of about `kCell` and away from corners.
class GoalFields {
 public:
  static constexpr double kCell = 0.1;  ///< [m] At least; never finer than the walk space's grid.

  /// Draws `places` places from the walk space, which must outlive this. @throws std::runtime_error
  /// if there is no room to walk.
  GoalFields(const WalkSpace& space, int places, Rng& rng);

  [[nodiscard]] const std::vector<Eigen::Vector2d>& places() const { return places_; }
  /// Returns the point to walk to from `p_map` on the way to a place: at most about 1.4 m ahead on
  /// the path, and reachable in a straight line. The first call for a place runs its search.
  [[nodiscard]] Eigen::Vector2d ahead(std::size_t place, const Eigen::Vector2d& p_map);

 private:
  using Index = std::uint32_t;
  using StepIndex = std::uint8_t;  ///< A byte: large maps have millions of cells.
  struct Frontier;

  [[nodiscard]] Index cell_near(const Eigen::Vector2d& p_map) const;
  [[nodiscard]] Eigen::Vector2d center(Index cell) const;
  [[nodiscard]] std::uint16_t exits(Index cell) const;
  [[nodiscard]] float price(Index cell) const;
  [[nodiscard]] Index neighbour(Index cell, std::size_t step) const;
  /// The step to take on the way to `goal`, by cell.
  [[nodiscard]] std::vector<StepIndex> search(Index goal) const;
  void spread(Index cell, Frontier& frontier, std::vector<StepIndex>& next) const;

  const WalkSpace& space_;
  Grid grid_;
  Eigen::Matrix2d cell_axes_;         ///< [m] One step in columns and one in rows, in map.
  std::vector<float> prices_;         ///< [m] Cost of entering a cell straight, by cell.
  std::vector<std::uint16_t> exits_;  ///< Bit set of the eight steps that can be taken, by cell.
  std::vector<Eigen::Vector2d> places_;
  std::vector<std::vector<StepIndex>> next_;  ///< By place and cell; empty before the search.
};

}  // namespace castaway::sim
