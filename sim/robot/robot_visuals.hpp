/// Visual shapes of a robot, for rendering.
#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "sim/robot/urdf/robot_model.hpp"
#include "sim/scene/scene.hpp"
#include "sim/sensor/lidar_config.hpp"

namespace castaway::sim {

/// For a robot without lidars, in base: a turret about the laser's frame and a mast below it if it
/// is above the body. Empty for a robot with lidars of its own.
std::vector<SceneItem> lidar_visuals(const RobotModel& robot, const LidarConfig& lidar);

/// The visual shapes of a robot in base (as if base were map), with all joints at 0. Meshes keep
/// the colours of their materials; meshes without (STL) and primitives have the URDF's. Reads mesh
/// files: call it once. @throws std::runtime_error if one cannot be read.
std::vector<SceneItem> robot_visuals(const RobotModel& robot);

}  // namespace castaway::sim
