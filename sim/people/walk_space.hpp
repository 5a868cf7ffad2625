/// Where people can be, and how far the walls are.
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "sim/map/free_space.hpp"
#include "sim/map/grid.hpp"
#include "sim/world/world.hpp"

namespace castaway::sim {

/// Distance to the nearest wall, and its gradient.
struct WallDistance {
  double distance = 0.0;  ///< [m]
  /// Gradient: a unit vector, shorter between walls.
  Eigen::Vector2d away = Eigen::Vector2d::Zero();
};

/// The map with all objects of a world marked that a body of 1.9 m could meet. Cells that are not
/// free on the map stay so.
Grid body_grid(const WorldSpec& world, const Grid& map);

/// Whether people who are in a part of the free space of their own can move in it.
enum class WalkParts : std::uint8_t { kLargest, kAll };

/// Largest connected part of a grid's free space in which a person can move, or all parts.
///
/// A point in it is at least `kBodyRoom` - 1.5 cells from everything solid. So between two of its
/// points that are less than twice that apart (a step of `kMaxStep`) there is nothing solid: a
/// person who only moves from one such point to the next passes through no wall.
class WalkSpace {
 public:
  static constexpr double kBodyRoom = 0.25;  ///< [m] Radius of the disc that must fit.
  static constexpr double kMaxStep = 0.15;   ///< [m]

  /// `grid`: from `body_grid`.
  explicit WalkSpace(const Grid& grid, WalkParts parts = WalkParts::kLargest);

  /// True if a person can stand at a point.
  [[nodiscard]] bool clear(const Eigen::Vector2d& p_map) const;
  /// True if a person can walk from `a` to `b` in a straight line.
  [[nodiscard]] bool clear(const Eigen::Vector2d& a, const Eigen::Vector2d& b) const;
  /// True if nothing solid is on the line between two points.
  [[nodiscard]] bool sees(const Eigen::Vector2d& a, const Eigen::Vector2d& b) const;
  /// Distance to the nearest wall, bilinear between the centres of cells; 0 outside of the grid.
  [[nodiscard]] WallDistance wall(const Eigen::Vector2d& p_map) const;
  /// Its free cells are where a person can stand.
  [[nodiscard]] const FreeSpace& free() const { return free_; }

 private:
  [[nodiscard]] Eigen::Vector2d to_cells(const Eigen::Vector2d& p_map) const;
  [[nodiscard]] double clearance(int column, int row) const;

  FreeSpace free_;
  Eigen::Matrix2d turn_;  ///< Rotation and scale from map to the grid's axes, in cells.
};

}  // namespace castaway::sim
