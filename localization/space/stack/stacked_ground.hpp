/// The ground of a 3-D map in the cells of a stack: where a robot may be.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "localization/space/map3d/atlas.hpp"
#include "localization/space/stack/stack_frame.hpp"

namespace castaway::localization {

/// The classes of an atlas' ground.
struct SlopeClasses {
  /// Mean rise along x and y of the grid of each class. The first is level ground, always there.
  std::vector<Eigen::Vector2d> slopes;
  std::vector<std::uint16_t> of_surface;  ///< For each surface of the ground.
};

/// Sorts the drivable surfaces: slopes of one class are at most about 0.03 from each other in
/// steepness, and 11 degrees in direction. Level: less than 0.02.
SlopeClasses sort_by_slope(const ElevationMap& ground);

/// Orientation of a robot in the grid that stands on a slope with a yaw. [rad]
Eigen::Matrix3d orientation_on(const Eigen::Vector2d& slope, double yaw);

/// Direction up in base for a robot that stands on a slope with a yaw. [rad]
inline Eigen::Vector3d up_on(const Eigen::Vector2d& slope, double yaw) {
  return orientation_on(slope, yaw).row(2).transpose();
}

/// A cell of a stack with ground.
struct GroundCell {
  Eigen::Vector2i cell = Eigen::Vector2i::Zero();
  std::uint16_t slope = 0;  ///< Its class.
};

/// Ground by cells of a stack, and back. The atlas must outlive it.
class StackedGround {
 public:
  StackedGround(const Atlas& atlas, const StackFrame& stack);

  /// Slopes of the classes of ground. Never empty; level ground first.
  [[nodiscard]] const std::vector<Eigen::Vector2d>& slopes() const { return classes_.slopes; }
  /// The cells of the stack with ground of a class, row by row.
  [[nodiscard]] std::vector<Eigen::Vector2i> cells_of_slope(std::uint16_t slope) const;
  /// Number of cells with ground.
  [[nodiscard]] std::size_t size() const { return places_.size(); }

  /// The cell under the centre of a cell of the atlas; nothing where it has no ground.
  [[nodiscard]] std::optional<GroundCell> cell_of(const Eigen::Vector2i& atlas_cell) const;
  /// The pose of base in the atlas with a yaw in the grid, on ground of a cell of the stack. [rad]
  /// Requires a cell with ground.
  [[nodiscard]] SE2 pose_at(const Eigen::Vector2i& cell, double yaw_grid) const;

 private:
  struct Place {
    std::uint32_t cell = 0;
    std::uint16_t slope = 0;
    std::uint32_t atlas_cell = 0;  ///< The one nearest to the cell's centre.
    int off_centre = 0;
  };

  void find_places();
  [[nodiscard]] Place place_of(const Eigen::Vector2i& atlas_cell) const;
  [[nodiscard]] Eigen::Vector2i stack_cell(const Place& place) const;

  const Atlas& atlas_;
  StackFrame stack_;
  SlopeClasses classes_;
  std::vector<Place> places_;  ///< Of each cell with ground, ascending.
};

}  // namespace castaway::localization
