/// Shortest ways from everywhere to a few places.
///
/// People share their goals, so that one search from each place (Dijkstra; A* with all starts at
/// once) serves all who ever go there, and following a path costs nothing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "sim/common/random.hpp"
#include "sim/people/walk_space.hpp"

namespace castaway::sim {

/// Places to go to, and the ways there: on cells of `kCell`, around corners with room to spare.
class GoalFields {
 public:
  static constexpr double kCell = 0.1;  ///< [m] At least; not finer than the walk space's grid.

  /// Draws `places` places from the walk space, which must outlive this. @throws std::runtime_error
  /// if nobody can walk anywhere.
  GoalFields(const WalkSpace& space, int places, Rng& rng);

  [[nodiscard]] const std::vector<Eigen::Vector2d>& places() const { return places_; }
  /// Where to walk to from `p_map` on the way to a place: a point of the path at most about 1.4 m
  /// ahead that can be reached in a straight line. The first call for a place searches the ways.
  [[nodiscard]] Eigen::Vector2d ahead(std::size_t place, const Eigen::Vector2d& p_map);

 private:
  using Index = std::uint32_t;
  using StepIndex = std::uint8_t;  ///< A byte: large maps have millions of cells.
  struct Frontier;

  [[nodiscard]] Index cell_near(const Eigen::Vector2d& p_map) const;
  [[nodiscard]] Eigen::Vector2d center(Index cell) const;
  [[nodiscard]] bool is_free(int column, int row) const;
  [[nodiscard]] std::uint16_t exits(Index cell) const;
  [[nodiscard]] float price(Index cell) const;
  [[nodiscard]] Index stepped(Index cell, std::size_t step) const;
  /// By cell: the step to take on the way to `goal`.
  [[nodiscard]] std::vector<StepIndex> search(Index goal) const;
  void spread(Index cell, Frontier& frontier, std::vector<StepIndex>& next) const;

  const WalkSpace& space_;
  Grid grid_;
  Eigen::Matrix2d cell_axes_;         ///< [m] A step in columns and in rows, in map.
  std::vector<float> prices_;         ///< By cell: of entering it straight. [m]
  std::vector<std::uint16_t> exits_;  ///< By cell: which of the eight steps can be taken.
  std::vector<Eigen::Vector2d> places_;
  std::vector<std::vector<StepIndex>> next_;  ///< By place and cell; empty until searched.
};

}  // namespace castaway::sim
