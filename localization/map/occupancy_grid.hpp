/// An occupancy grid, and the convention between metres and cells.
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "localization/geometry/random.hpp"
#include "localization/geometry/se2.hpp"

namespace castaway::localization {

/// Geometry of a grid. The grid's frame has its origin at the lower left corner of cell (0, 0), x
/// along the columns and y along the rows: a point p_grid lies in cell `floor(p_grid /
/// resolution)`, and cell centres lie at `(index + 0.5) * resolution`.
struct GridFrame {
  int width = 0;             ///< [cells]
  int height = 0;            ///< [cells]
  double resolution = 0.05;  ///< [m] Edge of a cell.
  SE2 T_map_grid;            ///< Origin of the ROS map, including yaw.

  [[nodiscard]] bool contains(const Eigen::Vector2i& cell) const {
    return cell.x() >= 0 && cell.y() >= 0 && cell.x() < width && cell.y() < height;
  }
  [[nodiscard]] std::size_t index(const Eigen::Vector2i& cell) const {
    return static_cast<std::size_t>(cell.y()) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(cell.x());
  }
  [[nodiscard]] std::size_t size() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
  /// The cell of a point in the grid's frame; may lie outside (see `cell_index`).
  [[nodiscard]] Eigen::Vector2i cell_of(const Eigen::Vector2d& p_grid) const;
  /// Centre of a cell in the grid's frame. [m]
  [[nodiscard]] Eigen::Vector2d centre_of(const Eigen::Vector2i& cell) const;
};

/// What is known about a cell.
enum class CellState : std::uint8_t { kFree, kOccupied, kUnknown };

/// A map: rows from the smallest y, `frame.size()` cells.
struct OccupancyGrid {
  GridFrame frame;
  std::vector<CellState> cells;

  /// State of the cell under a point in map; unknown off the map.
  [[nodiscard]] CellState at(const Eigen::Vector2d& p_map) const;
};

/// @throws std::invalid_argument if the grid is invalid: no cells, cells smaller than 1 um or
/// larger than 100 m, or a wrong number of cells.
void validate(const OccupancyGrid& grid);

/// Draws poses uniformly from the free cells of a map and from all yaws.
class FreeSpace {
 public:
  explicit FreeSpace(const OccupancyGrid& grid);
  [[nodiscard]] bool empty() const { return cells_.empty(); }
  /// Draws a pose of base in map. Requires a space that is not empty.
  [[nodiscard]] SE2 sample(Rng& rng) const;

 private:
  GridFrame frame_;
  std::vector<std::uint32_t> cells_;  ///< Indices of the free cells.
};

}  // namespace castaway::localization
