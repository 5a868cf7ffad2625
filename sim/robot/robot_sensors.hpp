/// Sensor settings from a robot's description.
#pragma once

#include <vector>

#include "sim/robot/urdf/robot_model.hpp"
#include "sim/sensor/lidar_config.hpp"
#include "sim/sensor/wheel_odometry.hpp"

namespace castaway::sim {

/// The lidar in the robot's description; values that it does not give keep their defaults. A robot
/// without a lidar gets one above its origin, 0.2 m above the floor or, if that is lower, 2 cm
/// above its highest part.
LidarConfig lidar_of(const RobotModel& robot);
/// All lidars in the description's order, named after their sensors or links; a single default one
/// if there are none.
std::vector<LidarConfig> lidars_of(const RobotModel& robot);

/// The true geometry of the robot's drive.
DriveGeometry drive_geometry(const RobotModel& robot);

}  // namespace castaway::sim
