/// What was understood of a robot, as a scene.
#pragma once

#include "sim/robot/urdf/robot_model.hpp"
#include "sim/scene/scene.hpp"

namespace castaway::testbed {

/// The robot from the front left on a floor of squares of 0.1 m (1 m for large ones); wheels
/// outlined in blue, casters in orange, the scans' planes in red, the axes of base.
/// @throws std::runtime_error if a mesh cannot be read.
sim::Scene robot_scene(const sim::RobotModel& robot);

}  // namespace castaway::testbed
