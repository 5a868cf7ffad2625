/// Distance of every cell to the nearest occupied cell.
///
/// P. Felzenszwalb, D. Huttenlocher, "Distance Transforms of Sampled Functions", Theory of
/// Computing 8 (2012), section 2: exact Euclidean distances between cell centres in O(cells).
#pragma once

#include <vector>

#include "localization/map/occupancy_grid.hpp"

namespace castaway::localization {

/// Distances at the cell centres. [m]
class DistanceField {
 public:
  /// Distances are capped at `max_distance` [m], which also applies off the map and on a map
  /// without walls.
  DistanceField(const OccupancyGrid& grid, double max_distance);

  [[nodiscard]] const GridFrame& frame() const { return frame_; }
  [[nodiscard]] double max_distance() const { return max_distance_; }
  /// Distance at the centre of a cell, row by row. [m]
  [[nodiscard]] const std::vector<float>& values() const { return values_; }
  /// Distance of the cell under a point in the grid's frame. [m]
  [[nodiscard]] double at(const Eigen::Vector2d& p_grid) const;

 private:
  GridFrame frame_;
  double max_distance_;
  std::vector<float> values_;
};

}  // namespace castaway::localization
