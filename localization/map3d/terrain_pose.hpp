/// The pose of a robot that stands on the ground: z, roll and pitch follow from where its wheels
/// are.
#pragma once

#include <optional>

#include <Eigen/Geometry>

#include "localization/map3d/elevation_map.hpp"

namespace castaway::localization {

/// Where the robot touches the ground: four points, ahead, behind and beside base.
struct WheelContacts {
  double ahead = 0.15;   ///< [m] Along x of base, in both directions.
  double beside = 0.15;  ///< [m] Along y of base, in both directions.
};

/// A robot's pose on the ground.
struct TerrainPose {
  Eigen::Isometry3d T_map_base = Eigen::Isometry3d::Identity();
  std::uint8_t level = 0;  ///< Of the surface under base.
};

/// Lifts a planar pose onto the surface nearest to the height `z` [m]; base is on the ground
/// (REP-103 base_footprint). x and y of base are kept. Nothing if a contact is not above any
/// ground, or more than 60 degrees above or below base.
std::optional<TerrainPose> stand(const ElevationMap& map, const SE2& T_map_base, double z,
                                 const WheelContacts& contacts);

}  // namespace castaway::localization
