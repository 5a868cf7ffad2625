/// Planar poses of the simulator.
#pragma once

#include <Eigen/Geometry>

namespace castaway::sim {

/// A pose in the plane: the robot's base (or any frame b) in map (or any frame a).
struct Pose2 {
  double x = 0.0;    ///< [m]
  double y = 0.0;    ///< [m]
  double yaw = 0.0;  ///< [rad] Counter-clockwise.
};

}  // namespace castaway::sim
