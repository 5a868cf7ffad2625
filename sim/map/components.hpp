/// The connected parts of a grid's free cells.
#pragma once

#include <cstddef>
#include <vector>

#include "sim/map/grid.hpp"

namespace castaway::sim {

/// Sizes and labels of the 4-connected components of free cells, numbered by their first cells.
/// Computed in two passes with a union of the rows' runs, which needs no stack and reads memory in
/// order.
class Components {
 public:
  explicit Components(const Grid& grid);

  /// Label of the largest component, the first of several equally large ones; 0 without any.
  [[nodiscard]] int largest() const;
  /// Component of each cell; -1 if the cell is not free.
  [[nodiscard]] const std::vector<int>& labels() const { return labels_; }

 private:
  int new_run();
  int root(int run);
  void join(int a, int b);
  void number();

  std::vector<int> labels_;
  std::vector<int> first_;  ///< By run: an earlier run of its component, or itself.
  std::vector<std::size_t> sizes_;
};

}  // namespace castaway::sim
