/// A planar occupancy grid as the simulator uses it: for extruding maps, rasterising worlds,
/// sampling and planning.
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace castaway::sim {

/// What is known about a cell.
enum class Cell : std::uint8_t { kFree, kOccupied, kUnknown };

/// Cells in rows, row 0 at the smallest y. Cell (column, row) covers
/// `[origin + (column, row) * resolution, origin + (column + 1, row + 1) * resolution)`.
struct Grid {
  int width = 0;                     ///< [cells]
  int height = 0;                    ///< [cells]
  double resolution = 0.05;          ///< [m] Edge of a cell.
  Eigen::Vector2d origin{0.0, 0.0};  ///< [m] Lower left corner in map.
  double origin_yaw = 0.0;           ///< [rad] Rotation of the grid about its origin.
  std::vector<Cell> cells;           ///< width * height

  [[nodiscard]] bool contains(int column, int row) const {
    return column >= 0 && row >= 0 && column < width && row < height;
  }
  [[nodiscard]] Cell at(int column, int row) const {
    return cells[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                 static_cast<std::size_t>(column)];
  }
  /// True if the cell lies in the grid and is free.
  [[nodiscard]] bool is_free(int column, int row) const {
    return contains(column, row) && at(column, row) == Cell::kFree;
  }
};

}  // namespace castaway::sim
