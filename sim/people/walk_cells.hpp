/// Cells that people's paths run over. Internal to sim/people.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "sim/people/walk_space.hpp"

namespace castaway::sim {

/// The walk space of a world on cells of about `kCell`, with what a step into each costs.
class WalkCells {
 public:
  using Index = std::uint32_t;

  static constexpr double kCell = 0.1;  ///< [m] At least; never finer than the walk space's grid.
  static constexpr std::size_t kSteps = 8;  ///< To the neighbours of a cell.
  static constexpr Index kNowhere = ~Index{0};
  /// Extra cost of a metre right beside a wall; a metre in the open costs 1.
  static constexpr double kComfortWeight = 3.0;

  explicit WalkCells(WalkSpace space);

  [[nodiscard]] const WalkSpace& space() const { return space_; }
  [[nodiscard]] const Grid& grid() const { return grid_; }
  /// Cells in which a person can stand anywhere, ascending.
  [[nodiscard]] const std::vector<Index>& free() const { return free_; }
  /// Middle of a cell in map. [m]
  [[nodiscard]] Eigen::Vector2d center(Index cell) const;
  /// The free cell at a point, or the nearest one within two cells, or `kNowhere`.
  [[nodiscard]] Index near(const Eigen::Vector2d& p_map) const;
  /// Cost of entering a free cell straight. [m]
  [[nodiscard]] float price(Index cell) const { return prices_[cell]; }
  /// True if a step can be taken from a free cell without cutting a corner.
  [[nodiscard]] bool has_exit(Index cell, std::size_t step) const {
    return (exits_[cell] & (1U << step)) != 0;
  }
  [[nodiscard]] Index neighbour(Index cell, std::size_t step) const;
  [[nodiscard]] static bool is_diagonal(std::size_t step);
  /// The step that undoes another.
  [[nodiscard]] static constexpr std::size_t back(std::size_t step) { return kSteps - 1 - step; }

 private:
  [[nodiscard]] float price_at(Index cell) const;
  [[nodiscard]] std::uint16_t exits_of(Index cell) const;

  WalkSpace space_;
  Grid grid_;
  Eigen::Matrix2d cell_axes_;  ///< [m] One step in columns and one in rows, in map.
  std::vector<float> prices_;
  std::vector<std::uint16_t> exits_;  ///< Bit set of steps.
  std::vector<Index> free_;
};

}  // namespace castaway::sim
