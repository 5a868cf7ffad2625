/// An occupancy grid, and the convention between metres and cells.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "castaway/pose.hpp"

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
  /// The cell of a point in the grid's frame; may lie outside of it.
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

/// The grid of a ROS map (nav_msgs/OccupancyGrid): -1 unknown, 0 free ... 100 occupied; rows from
/// the smallest y. As in Nav2's trinary mode, cells are occupied from 65 % on and free up to 19.6
/// %, and unknown in between or if the map says so.
OccupancyGrid trinary_grid(const GridFrame& frame, std::span<const std::int8_t> cells);

}  // namespace castaway::localization

namespace castaway {

using localization::CellState;
using localization::GridFrame;
using localization::OccupancyGrid;
using localization::trinary_grid;
using localization::validate;

}  // namespace castaway
