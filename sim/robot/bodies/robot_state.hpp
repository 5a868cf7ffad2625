/// The motion state of a robot.
#pragma once

#include <Eigen/Geometry>

#include "sim/sensor/wheel_odometry.hpp"

namespace castaway::sim {

/// Pose and wheel angles of a robot.
struct RobotState {
  Eigen::Isometry3d T_map_base = Eigen::Isometry3d::Identity();
  WheelAngles wheels;  ///< Mean of each side.
};

}  // namespace castaway::sim
