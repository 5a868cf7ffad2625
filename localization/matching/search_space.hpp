/// The space of a search: yaw steps, a rectangle of coarse cells, and the offsets of a scan's end
/// points at each yaw.
#pragma once

#include <optional>
#include <vector>

#include "localization/map/occupancy_grid.hpp"
#include "localization/sensor/scan_points.hpp"

namespace castaway::localization {

/// Restricts a search to a window around a pose.
struct MatchWindow {
  SE2 centre;               ///< Pose of base in map.
  double radius = 1.1;      ///< [m] Half edge of the square.
  double yaw_radius = 0.6;  ///< [rad]
};

/// Cells and yaws of a search.
struct SearchSpace {
  Eigen::Vector2i low{0, 0};     ///< First column and row.
  Eigen::Vector2i high{-1, -1};  ///< Last column and row, included.
  /// Yaw steps, ascending; step k is the yaw `2 pi k / steps` in the grid's frame.
  std::vector<int> yaws;

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

/// The search space of a whole grid, or of its part in a window.
SearchSpace search_space(const GridFrame& frame, int yaw_steps,
                         const std::optional<MatchWindow>& window);

/// Offset of an end point in coarse cells; base is at the centre of its cell.
struct CellOffset {
  int dx = 0;
  int dy = 0;
};

/// At most `count` points, evenly spread over the scan, rotated by a yaw in the grid's frame.
/// Points `reach` cells away or farther are left out.
std::vector<CellOffset> rotate_scan(const ScanPoints& points, int count, double resolution,
                                    double yaw_grid, int reach);

/// The yaw of a step. [rad]
double yaw_of_step(int step, int steps);

}  // namespace castaway::localization
