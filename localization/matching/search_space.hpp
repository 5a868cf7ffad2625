/// What a search tries: steps of yaw, a rectangle of coarse cells, and where the end points of a
/// scan come to lie at each yaw.
#pragma once

#include <optional>
#include <vector>

#include "localization/map/occupancy_grid.hpp"
#include "localization/sensor/scan_points.hpp"

namespace castaway::localization {

/// Restricts a search to the surroundings of a pose.
struct MatchWindow {
  SE2 centre;               ///< Pose of base in map.
  double radius = 1.1;      ///< [m] Half edge of the square.
  double yaw_radius = 0.6;  ///< [rad]
};

/// Cells and yaws to be tried.
struct SearchSpace {
  Eigen::Vector2i low{0, 0};     ///< First column and row.
  Eigen::Vector2i high{-1, -1};  ///< Last column and row, included.
  std::vector<int> yaws;         ///< Steps, ascending; step k is the yaw `2 pi k / steps` in grid.

  [[nodiscard]] bool contains(const Eigen::Vector2i& cell) const {
    return cell.x() >= low.x() && cell.x() <= high.x() && cell.y() >= low.y() &&
           cell.y() <= high.y();
  }
};

/// A tile (`PooledField`) at one yaw.
struct Tile {
  int column = 0;
  int row = 0;
  int yaw = 0;  ///< Index into the space's yaws.
};

/// All of a grid, or the part of it in a window.
SearchSpace search_space(const GridFrame& frame, int yaw_steps,
                         const std::optional<MatchWindow>& window);

/// Where an end point lies, in coarse cells from the one in whose centre base stands.
struct CellOffset {
  int dx = 0;
  int dy = 0;
};

/// At most `count` points, even over the scan, turned by a yaw in the grid's frame. Points `reach`
/// cells away or farther are left out.
std::vector<CellOffset> turned_scan(const ScanPoints& points, int count, double resolution,
                                    double yaw_grid, int reach);

/// The yaw of a step. [rad]
double yaw_of_step(int step, int steps);

}  // namespace castaway::localization
