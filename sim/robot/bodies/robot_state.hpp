/// Where a robot is.
#pragma once

#include <Eigen/Geometry>

#include "sim/sensor/wheel_odometry.hpp"

namespace castaway::sim {

/// Where a robot is.
struct RobotState {
  Eigen::Isometry3d T_map_base = Eigen::Isometry3d::Identity();
  WheelAngles wheels;  ///< Means of each side.
};

}  // namespace castaway::sim
