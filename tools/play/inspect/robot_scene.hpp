/// A loaded robot as a scene.
#pragma once

#include "sim/robot/urdf/robot_model.hpp"
#include "sim/scene/scene.hpp"

namespace castaway::testbed {

/// Shows the robot from the front left on a floor of squares of 0.1 m (1 m for large robots):
/// wheels outlined in blue, casters in orange, scan planes in red, and the axes of base. Throws
/// std::runtime_error if a mesh cannot be read.
sim::Scene robot_scene(const sim::RobotModel& robot);

}  // namespace castaway::testbed
