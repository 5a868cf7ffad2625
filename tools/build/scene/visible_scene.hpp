/// What can be seen of a simulation.
#pragma once

#include <vector>

#include "sim/robot/urdf/robot_model.hpp"
#include "sim/sensor/lidar_config.hpp"
#include "sim/world/world.hpp"
#include "tools/build/scene/page_scene.hpp"

namespace castaway::testbed {

/// The floor, just below z = 0.
sim::SceneItem floor_item(const sim::WorldSpec& world);

/// The robot in base, with all joints at 0; a lidar that its file does not contain is added.
std::vector<sim::SceneItem> robot_items(const sim::RobotModel& robot,
                                        const std::vector<sim::LidarConfig>& lidars);

/// A world for pages. @throws std::runtime_error if a mesh cannot be read.
PageWorld page_world(const sim::WorldSpec& world);

}  // namespace castaway::testbed
