/// What a lidar looks like that a robot's file knows nothing of.
#pragma once

#include <vector>

#include "sim/robot/urdf/robot_model.hpp"
#include "sim/scene/scene.hpp"
#include "sim/sensor/lidar_config.hpp"

namespace castaway::sim {

/// For a robot without lidars, in base: a turret about the laser's frame and, where that is above
/// the body, a mast beneath it. None for a robot that has its own.
std::vector<SceneItem> lidar_visuals(const RobotModel& robot, const LidarConfig& lidar);

}  // namespace castaway::sim
