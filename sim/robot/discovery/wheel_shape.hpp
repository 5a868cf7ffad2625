/// The shape of a drive wheel. Internal to sim/robot.
#pragma once

#include <optional>

#include "sim/robot/urdf/urdf_parts.hpp"

namespace castaway::sim {

/// A wheel about its joint.
struct WheelShape {
  double radius = 0.0;  ///< [m]
  double shift = 0.0;   ///< [m] Of its middle along y from the joint.
  bool exact = false;   ///< A cylinder or a ball; false: measured on a box or mesh.
};

/// From the collision shapes of the wheel's link, else from the visual ones; nothing if there are
/// none or they have no extent.
std::optional<WheelShape> wheel_shape(const urdf::Link& link, const LinkFrames& frames,
                                      const MeshFinder& finder);

}  // namespace castaway::sim
