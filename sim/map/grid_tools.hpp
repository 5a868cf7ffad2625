/// Geometry of grids: cells and points, distances, erosion, connected components.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

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

/// Column and row of a cell; may lie outside of the grid.
struct CellIndex {
  int column = 0;
  int row = 0;
  bool operator==(const CellIndex&) const = default;
};

/// Index into `Grid::cells` of a cell within the grid.
inline std::size_t flat_index(const Grid& grid, CellIndex cell) {
  return static_cast<std::size_t>(cell.row) * static_cast<std::size_t>(grid.width) +
         static_cast<std::size_t>(cell.column);
}
/// Column and row of an index into `Grid::cells`.
inline CellIndex cell_at_index(const Grid& grid, std::size_t index) {
  const auto width = static_cast<std::size_t>(grid.width);
  return {static_cast<int>(index % width), static_cast<int>(index / width)};
}

/// A grid of `width` x `height` cells, all `value`.
Grid make_grid(int width, int height, double resolution, const Eigen::Vector2d& origin, Cell value);

/// The cell that contains a point in map.
CellIndex cell_of(const Grid& grid, const Eigen::Vector2d& p_map);
/// Centre of a cell in map. [m]
Eigen::Vector2d center_of(const Grid& grid, CellIndex cell);
/// Value at a point in map; unknown outside of the grid.
Cell cell_at(const Grid& grid, const Eigen::Vector2d& p_map);

/// What is assumed beyond a grid's outermost cells.
enum class GridEdge : std::uint8_t {
  kWall,  ///< Cells that are not free.
  kOpen,  ///< More of the same.
};

/// Euclidean distance from each cell's centre to the centre of the nearest cell that is not free,
/// [m]; 0 in those. Linear in the number of cells.
std::vector<float> distance_to_obstacle(const Grid& grid, GridEdge edge = GridEdge::kWall);

/// The grid with free cells nearer than `radius` [m] to an obstacle made occupied: its free cells
/// are where the centre of a disc can be. Errs on the safe side by up to half a cell.
Grid erode(const Grid& grid, double radius);
/// The same with known distances to obstacles.
Grid erode(const Grid& grid, const std::vector<float>& distance, double radius);

/// Index of the 4-connected component of each free cell, from 0; -1 for other cells.
std::vector<int> component_labels(const Grid& grid);

/// The grid with all free cells but the largest 4-connected component made unknown.
Grid largest_component(const Grid& grid);

/// The same with the component that contains a point; the largest one if the point is not free.
Grid component_at(const Grid& grid, const Eigen::Vector2d& p_map);

}  // namespace castaway::sim
