/// What a robot's sensors are by its description.
#pragma once

#include <vector>

#include "sim/robot/urdf/robot_model.hpp"
#include "sim/sensor/lidar_config.hpp"
#include "sim/sensor/wheel_odometry.hpp"

namespace castaway::sim {

/// The lidar that the robot's description carries; what it does not say keeps its default. A robot
/// without any gets one over its origin, 0.2 m above the floor or, where that is lower, 2 cm above
/// its highest part.
LidarConfig lidar_of(const RobotModel& robot);
/// All lidars, in the description's order, named by their sensors or links; without any one of the
/// defaults.
std::vector<LidarConfig> lidars_of(const RobotModel& robot);

/// The true geometry of the robot's drive.
DriveGeometry drive_geometry(const RobotModel& robot);

}  // namespace castaway::sim
