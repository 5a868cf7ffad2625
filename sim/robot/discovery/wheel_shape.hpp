/// The shape of a drive wheel. Internal to sim/robot.
#pragma once

#include <optional>

#include "sim/robot/urdf/urdf_parts.hpp"

namespace castaway::sim {

/// Shape of a wheel about its joint.
struct WheelShape {
  double radius = 0.0;  ///< [m]
  double shift = 0.0;   ///< [m] From the joint to the wheel's centre, along y.
  bool exact = false;   ///< A cylinder or a ball; false: measured on a box or mesh.
};

/// The shape by the collision shapes of the wheel's link, or by the visual ones if there are none;
/// nothing if there are neither or they have no extent.
std::optional<WheelShape> wheel_shape(const urdf::Link& link, const LinkFrames& frames,
                                      const MeshFinder& finder);

}  // namespace castaway::sim
