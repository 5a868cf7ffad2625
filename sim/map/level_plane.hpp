/// The ground of several floors, laid out in one plane.
///
/// Floors that lie above each other, and the ramps between them, are cut into charts: parts with
/// one surface in each cell. Charts lie one behind the other in a tall grid, so that free space,
/// routes and kidnaps of planar poses serve for buildings, too. Frame plane: that grid's; it
/// differs from map by a translation along y for each chart.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "sim/common/geometry.hpp"
#include "sim/map/grid.hpp"
#include "sim/map/grid_tools.hpp"

namespace castaway::sim {

/// The ground in a cell of the plane.
struct LevelCell {
  float z = 0.0F;          ///< [m] In map, at the cell's centre.
  float slope_x = 0.0F;    ///< Rise of z along x, per metre.
  float slope_y = 0.0F;    ///< Rise of z along y, per metre.
  std::uint8_t level = 0;  ///< The floor that it belongs to, from below.
  std::int32_t own = -1;   ///< The one cell that its surface belongs to; -1: no ground.
};

/// Charts overlap by a margin: a cell whose surface belongs to another chart says to which.
struct LevelPlane {
  Grid grid;                     ///< Free where there is ground; not turned (`origin_yaw` is 0).
  int stride = 0;                ///< Rows from a chart to the next.
  std::vector<LevelCell> cells;  ///< By cell of `grid`.
  int levels = 1;                ///< Number of floors.

  /// True if a cell's surface belongs to it.
  [[nodiscard]] bool is_own(std::size_t cell) const {
    return cells[cell].own == static_cast<std::int32_t>(cell);
  }
  /// The cell at a point of the plane; null outside of it.
  [[nodiscard]] const LevelCell* at(const Eigen::Vector2d& p_plane) const;
  /// The pose in map.
  [[nodiscard]] Pose2 in_map(const Pose2& T_plane_base) const;
  /// The pose in the chart whose own ground is nearest to the height `z` [m]; nothing if there is
  /// no ground within 1 m of it.
  [[nodiscard]] std::optional<Pose2> on_plane(const Pose2& T_map_base, double z) const;
  /// The same, however far in height.
  [[nodiscard]] std::optional<Pose2> nearest_ground(const Pose2& T_map_base, double z) const;
  /// The pose on a level; without one, on the lowest ground at its place. Nothing if there is none.
  [[nodiscard]] std::optional<Pose2> on_level(const Pose2& T_map_base,
                                              std::optional<int> level) const;
  /// A point in map on the ground. [m] At z = 0 where there is none.
  [[nodiscard]] Eigen::Vector3d p_map(const Eigen::Vector2d& p_plane) const;
  /// T_map_base of a base that stands on the ground, tilted as it is.
  [[nodiscard]] Eigen::Isometry3d standing_at(const Pose2& T_plane_base) const;
  /// Slope of the ground at a point: rise per metre of its steepest direction.
  [[nodiscard]] double slope_at(const Eigen::Vector2d& p_plane) const;
};

/// The largest part of the free cells of `eroded`, a grid like the plane's, that can be reached
/// from each other across charts; all other cells are unknown, and so are those that belong to
/// other charts.
Grid largest_part(const LevelPlane& plane, Grid eroded);

}  // namespace castaway::sim
