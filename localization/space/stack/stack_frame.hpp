/// Geometry of a stack: the coarse cells of a 3-D map, plane behind plane in one grid.
///
/// Planes have equal heights. A point above or below base is some rows farther on, so that the
/// search of a planar map (`PooledField`) finds places on all floors. Between the planes lie as
/// many empty rows as points may reach.
#pragma once

#include <cmath>
#include <cstdint>

#include "localization/map/occupancy_grid.hpp"
#include "localization/space/map3d/elevation_map.hpp"

namespace castaway::localization {

/// Parameters of a stack.
struct StackConfig {
  double resolution = 0.2;  ///< [m] Edge of a coarse cell; rounded to a multiple of the map's.
  double height = 0.3;      ///< [m] Of a plane.
  double reach = 20.0;      ///< [m] End points farther from base in x or y are left out.
  double reach_up = 6.0;    ///< [m] End points farther above or below base are left out.
};

/// @throws std::invalid_argument if a value is out of range.
void validate(const StackConfig& config);

/// Sizes of a stack.
struct StackFrame {
  /// Covers the drivable ground of a map, and what points reach from it.
  /// @throws std::invalid_argument for invalid parameters, or if there would be too many cells.
  StackFrame(const ElevationMap& ground, const StackConfig& config);

  GridFrame plane;       ///< Coarse cells of one plane.
  int factor = 1;        ///< Cells of the ground in a coarse one, in x and y.
  double height;         ///< [m] Of a plane.
  double first_z = 0.0;  ///< [m] Lower edge of the lowest plane.
  int planes = 0;
  int pitch = 0;     ///< [rows] From a cell to the one above it.
  int reach = 0;     ///< [cells] Exclusive limit of end points in x and y.
  int reach_up = 0;  ///< [planes] Limit of end points above and below base.

  /// The plane of a height; may lie outside.
  [[nodiscard]] int plane_of(double z) const {
    return static_cast<int>(std::floor((z - first_z) / height));
  }
  /// The cell of the stack for a coarse cell of the ground in a plane.
  [[nodiscard]] Eigen::Vector2i stacked(const Eigen::Vector2i& cell, int in_plane) const {
    return {cell.x(), cell.y() + in_plane * pitch};
  }
  /// The stack as one grid; its T_map_grid is that of the ground.
  [[nodiscard]] GridFrame grid() const {
    return {plane.width, planes * pitch, plane.resolution, plane.T_map_grid};
  }
};

}  // namespace castaway::localization
