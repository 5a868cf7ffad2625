/// Neighbours in a set of points, by square cells.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include <Eigen/Core>

namespace castaway::sim {

/// Points ordered by the cell that they are in, row by row; in a cell, by their index. Finding all
/// neighbours within an edge costs as much as there are points in nine cells each (cell lists: M.
/// P. Allen and D. J. Tildesley, "Computer Simulation of Liquids", 1987, section 5.3.2).
class CellList {
 public:
  /// `edge`: of a cell, at least [m]. Cells are larger where points are few, so that there are no
  /// more cells than four per point.
  CellList(const std::vector<Eigen::Vector2d>& points, double edge);

  /// Indices of the points, in the order of their cells.
  [[nodiscard]] const std::vector<std::size_t>& order() const { return order_; }

  /// Calls `visit(begin, end)` for runs of places in `order()` after `place`, which hold all later
  /// points within `rings` edges of the point there. So every pair is visited once.
  template <typename Visit>
  void visit_later(std::size_t place, int rings, Visit visit) const {
    const int column = cell_[place] % columns_;
    const int row = cell_[place] / columns_;
    const int left = std::max(column - rings, 0);
    const int right = std::min(column + rings, columns_ - 1);
    visit(place + 1, begin_of(row, right + 1));
    for (int r = row + 1; r <= row + rings && r < rows_; ++r) {
      visit(begin_of(r, left), begin_of(r, right + 1));
    }
  }

 private:
  /// Place in `order()` of the first point of a cell or of a later one.
  [[nodiscard]] std::size_t begin_of(int row, int column) const {
    return begin_[static_cast<std::size_t>(row * columns_ + column)];
  }

  int columns_ = 1;
  int rows_ = 1;
  std::vector<std::size_t> begin_;  ///< By cell, and the number of points.
  std::vector<std::size_t> order_;
  std::vector<int> cell_;  ///< By place in `order_`.
};

using IndexPairs = std::vector<std::pair<std::size_t, std::size_t>>;

/// Pairs (i, j), i < j, of points at most `reach` [m] apart, in lexicographic order.
IndexPairs near_pairs(const std::vector<Eigen::Vector2d>& points, double reach);

}  // namespace castaway::sim
