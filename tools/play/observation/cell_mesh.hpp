/// Cells of a grid as rectangles of a mesh.
#pragma once

#include <array>

#include "localization/map/occupancy_grid.hpp"
#include "sim/scene/primitives.hpp"
#include "sim/scene/scene.hpp"
#include "tools/play/observation/map_window.hpp"

namespace castaway::testbed {

/// Four corners, counter-clockwise from above. [m]
using CellCorners = std::array<Eigen::Vector3f, 4>;

/// Adds a rectangle of one colour.
void add_cell(const CellCorners& corners, const Eigen::Vector3f& normal,
              const Eigen::Vector3f& color, sim::TriangleMesh& mesh);

/// Calls `take` with the cells of a grid whose centres are in a window, row by row.
template <typename Take>
void for_cells(const localization::GridFrame& frame, const MapWindow& window, const Take& take) {
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      const Eigen::Vector2i cell(x, y);
      if (window.contains(frame.T_map_grid * frame.centre_of(cell))) take(cell);
    }
  }
}

/// The corners of a cell drawn with this edge [m]; `height` [m] takes a point of the grid's frame
/// from the cell's centre.
template <typename Height>
CellCorners cell_corners(const localization::GridFrame& frame, const Eigen::Vector2i& cell,
                         double edge, const Height& height) {
  const double half = 0.5 * edge;
  const std::array<Eigen::Vector2d, 4> offsets{
      Eigen::Vector2d(-half, -half), Eigen::Vector2d(half, -half), Eigen::Vector2d(half, half),
      Eigen::Vector2d(-half, half)};
  CellCorners corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector2d p_map = frame.T_map_grid * (frame.centre_of(cell) + offsets[i]);
    corners[i] = sim::raise_point(p_map, height(offsets[i]));
  }
  return corners;
}

}  // namespace castaway::testbed
