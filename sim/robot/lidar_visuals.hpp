/// The looks of a lidar that a robot's file does not contain.
#pragma once

#include <vector>

#include "sim/robot/urdf/robot_model.hpp"
#include "sim/scene/scene.hpp"
#include "sim/sensor/lidar_config.hpp"

namespace castaway::sim {

/// For a robot without lidars, in base: a turret about the laser's frame and a mast below it if it
/// is above the body. Empty for a robot with lidars of its own.
std::vector<SceneItem> lidar_visuals(const RobotModel& robot, const LidarConfig& lidar);

}  // namespace castaway::sim
