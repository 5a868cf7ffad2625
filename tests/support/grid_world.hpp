/// A world of grid cells for tests of localizers: an office without symmetry, and scans simulated
/// in it.
#pragma once

#include <cmath>
#include <limits>
#include <numbers>

#include "castaway/localizer.hpp"
#include "localization/map/occupancy_grid.hpp"

namespace castaway::test {

using localization::CellState;
using localization::OccupancyGrid;
using localization::SE2;

/// Fills the cells of a rectangle given in metres.
inline void fill(OccupancyGrid& grid, double x0, double y0, double x1, double y1, CellState state) {
  const double r = grid.frame.resolution;
  for (int row = 0; row < grid.frame.height; ++row) {
    for (int column = 0; column < grid.frame.width; ++column) {
      const double x = (column + 0.5) * r;
      const double y = (row + 0.5) * r;
      if (x >= x0 && x < x1 && y >= y0 && y < y1)
        grid.cells[grid.frame.index({column, row})] = state;
    }
  }
}

/// 10 x 8 m with outer walls, an inner wall with a doorway, and three pieces of furniture.
inline OccupancyGrid office() {
  OccupancyGrid grid;
  grid.frame = {200, 160, 0.05, {}};
  grid.cells.assign(grid.frame.size(), CellState::kOccupied);
  fill(grid, 0.2, 0.2, 9.8, 7.8, CellState::kFree);
  fill(grid, 5.9, 0.0, 6.1, 5.0, CellState::kOccupied);
  fill(grid, 5.9, 6.2, 6.1, 8.0, CellState::kOccupied);
  fill(grid, 1.0, 0.2, 2.5, 1.0, CellState::kOccupied);
  fill(grid, 3.0, 5.5, 3.5, 7.8, CellState::kOccupied);
  fill(grid, 8.5, 2.0, 9.8, 3.1, CellState::kOccupied);
  return grid;
}

/// Range [m] from a point in map along a heading to the first occupied cell; infinity beyond
/// `longest`.
inline double cast(const OccupancyGrid& grid, const Eigen::Vector2d& from, double heading,
                   double longest) {
  const Eigen::Vector2d direction(std::cos(heading), std::sin(heading));
  for (double t = 0.0; t < longest; t += 0.002) {
    if (grid.at(from + t * direction) == CellState::kOccupied) return t;
  }
  return std::numeric_limits<double>::infinity();
}

/// A noise-free scan of `beams` beams over a full turn, all at the same time, by a lidar at the
/// origin of base.
inline localization::LaserScan scan_at(const OccupancyGrid& grid, const SE2& T_map_base,
                                       localization::Stamp stamp, int beams = 120) {
  localization::LaserScan scan;
  scan.stamp = stamp;
  scan.angle_min = -std::numbers::pi;
  scan.angle_increment = 2.0 * std::numbers::pi / beams;
  scan.range_min = 0.05;
  scan.range_max = 12.0;
  for (int i = 0; i < beams; ++i) {
    const double heading = T_map_base.yaw + scan.beam_angle(static_cast<std::size_t>(i));
    scan.ranges.push_back(
        static_cast<float>(cast(grid, T_map_base.translation(), heading, scan.range_max)));
  }
  return scan;
}

}  // namespace castaway::test
