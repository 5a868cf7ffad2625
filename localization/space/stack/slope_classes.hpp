/// Ground sorted by slope: robots that stand on ground of one class with the same yaw are tilted
/// alike.
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Geometry>

#include "localization/space/map3d/atlas.hpp"

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

}  // namespace castaway::localization
