/// The ground of a 3-D map in the cells of a stack: where a robot may be.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "localization/space/map3d/atlas.hpp"
#include "localization/space/stack/slope_classes.hpp"
#include "localization/space/stack/stack_frame.hpp"

namespace castaway::localization {

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
