/// An elevation map with several surfaces in a cell: floors above each other, ramps between them.
///
/// R. Triebel, P. Pfaff, W. Burgard, "Multi-level surface maps for outdoor terrain mapping and loop
/// closing", IROS 2006. Differences: a surface has a slope in place of a variance, and no depth.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "localization/map/occupancy_grid.hpp"

namespace castaway::localization {

/// A surface that faces up, at the centre of a cell.
struct GroundSurface {
  float z = 0.0F;          ///< [m] In map.
  float slope_x = 0.0F;    ///< Rise of z along x of the grid, per metre.
  float slope_y = 0.0F;    ///< Rise of z along y of the grid, per metre.
  float clearance = 0.0F;  ///< [m] Free height above it; infinite under the sky.
  std::uint8_t level = 0;  ///< Index into `ElevationMap::levels`.
  bool drivable = false;   ///< Wide and level enough for wheels, with room above.
};

/// Cells with their surfaces.
struct ElevationMap {
  GridFrame frame;
  std::vector<std::uint32_t> first;  ///< Index of each cell's first surface; one more at the end.
  std::vector<GroundSurface> surfaces;  ///< By cell, ascending in z.
  std::vector<float> levels;            ///< [m] Heights of the floors, ascending; at least one.

  /// Surfaces of a cell; none outside of the grid.
  [[nodiscard]] std::span<const GroundSurface> at(const Eigen::Vector2i& cell) const;
};

/// @throws std::invalid_argument if the parts of the map do not agree with each other.
void validate(const ElevationMap& map);

/// Transform from map to the grid of an elevation map, prepared for many points.
[[nodiscard]] inline PlaneTransform grid_from_map(const ElevationMap& map) {
  return PlaneTransform(map.frame.T_map_grid.inverse());
}

/// The surface of the cell under `p_map` [m] that is nearest to the height `z` [m]; null if the
/// cell has none.
const GroundSurface* surface_near(const ElevationMap& map, const Eigen::Vector2d& p_map, double z);

/// Height of the ground under `p_map` on the surface nearest to `z`, continued within its cell by
/// its slope. [m] NaN where there is no surface.
double ground_height(const ElevationMap& map, const Eigen::Vector2d& p_map, double z);

/// A point of the ground.
struct GroundPoint {
  const GroundSurface* surface = nullptr;               ///< Null: none.
  double z = std::numeric_limits<double>::quiet_NaN();  ///< [m]
};
/// `surface_near` and `ground_height` of a point of the map's grid. [m]
GroundPoint ground_at(const ElevationMap& map, const Eigen::Vector2d& p_grid, double z);

}  // namespace castaway::localization
