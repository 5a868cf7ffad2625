/// The pose of a robot that stands on the ground: z, roll and pitch follow from where its wheels
/// are.
#pragma once

#include <optional>

#include <Eigen/Geometry>

#include "localization/space/map3d/elevation_map.hpp"
#include "localization/space/map3d/wheel_stance.hpp"

namespace castaway::localization {

/// A robot's pose on the ground.
struct TerrainPose {
  Eigen::Isometry3d T_map_base = Eigen::Isometry3d::Identity();
  std::uint8_t level = 0;  ///< Of the surface under base.
};

/// Lifts a planar pose onto the surface nearest to the height `z` [m]; base is on the ground
/// (REP-103 base_footprint). x and y of base are kept. Nothing if a wheel is not above any ground,
/// or more than 60 degrees above or below base. `T_grid_map`: of `grid_from_map`.
std::optional<TerrainPose> stand(const ElevationMap& map, const PlaneTransform& T_grid_map,
                                 const SE2& T_map_base, double z, const WheelStance& wheels);

}  // namespace castaway::localization
