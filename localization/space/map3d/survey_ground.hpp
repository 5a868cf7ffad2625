/// Finds the ground in a 3-D map: an elevation map with levels.
#pragma once

#include <optional>

#include "localization/space/map3d/elevation_map.hpp"
#include "localization/space/map3d/voxel_map.hpp"

namespace castaway::localization {

/// Leaves only those surfaces drivable that are connected with the drivable surface nearest to
/// `start` [m], or without a start, or without one near it (1 m), the largest connected part.
/// Neighbouring cells are connected if they differ in height by at most `step`. [m]
void keep_reachable(ElevationMap& map, const std::optional<Eigen::Vector3d>& start, double step);

/// What a robot can drive on.
struct GroundConfig {
  double clearance = 1.0;     ///< [m] Least free height above a surface that counts as ground.
  double max_slope = 0.35;    ///< Steepest slope that is drivable: rise per metre.
  double step = 0.06;         ///< [m] Largest step between neighbouring cells on a way.
  double level_slope = 0.02;  ///< Surfaces that rise less are level.
  double level_area = 20.0;   ///< [m^2] A level surface of this area is a floor.
  double level_height = 1.0;  ///< [m] Floors nearer in height than this are the same level.
};

/// @throws std::invalid_argument if a value is out of range.
void validate(const GroundConfig& config);

/// Finds all surfaces with room above them. Cells are as large as voxels. A surface is drivable if
/// it has neighbours on (nearly) all sides and they rise at most by `max_slope`.
/// @throws std::invalid_argument for an invalid map or configuration, or an empty map.
ElevationMap survey_ground(const VoxelMap& map, const GroundConfig& config,
                           const std::optional<Eigen::Vector3d>& start = std::nullopt);

}  // namespace castaway::localization
