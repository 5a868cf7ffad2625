/// Where people can be, and how far the walls are.
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "sim/map/free_space.hpp"
#include "sim/map/grid.hpp"
#include "sim/world/world_spec.hpp"

namespace castaway::sim {

/// Distance to the nearest wall, and its gradient.
struct WallDistance {
  double distance = 0.0;                           ///< [m]
  Eigen::Vector2d away = Eigen::Vector2d::Zero();  ///< Gradient: unit, less where walls compete.
};

/// The map with all objects of a world that a body of 1.9 m could meet. What is not free on the map
/// stays so.
Grid body_grid(const WorldSpec& world, const Grid& map);

/// Largest connected part of a grid's free space in which a person can move about.
///
/// A point in it is at least `kBodyRoom` - 1.5 cells from all that is solid. So between two points
/// of it that are less than twice that apart (a step of `kMaxStep`) there is nothing solid: who
/// only ever goes from one to the other passes no wall.
class WalkSpace {
 public:
  static constexpr double kBodyRoom = 0.25;  ///< [m] Of the disc that must fit.
  static constexpr double kMaxStep = 0.15;   ///< [m]

  /// `grid`: as of `body_grid`.
  explicit WalkSpace(const Grid& grid);

  /// True if a person can stand at a point.
  [[nodiscard]] bool clear(const Eigen::Vector2d& p_map) const;
  /// True if it can walk from `a` to `b` in a straight line.
  [[nodiscard]] bool clear(const Eigen::Vector2d& a, const Eigen::Vector2d& b) const;
  /// True if nothing solid is on the line between two points.
  [[nodiscard]] bool sees(const Eigen::Vector2d& a, const Eigen::Vector2d& b) const;
  /// Bilinear between the centres of cells; 0 outside of the grid.
  [[nodiscard]] WallDistance wall(const Eigen::Vector2d& p_map) const;
  /// Free: a person can stand there.
  [[nodiscard]] const FreeSpace& free() const { return free_; }

 private:
  [[nodiscard]] Eigen::Vector2d to_cells(const Eigen::Vector2d& p_map) const;
  [[nodiscard]] double clearance(int column, int row) const;

  FreeSpace free_;
  Eigen::Matrix2d turn_;  ///< From map to the axes of the grid, in cells.
};

}  // namespace castaway::sim
