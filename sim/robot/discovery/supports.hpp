/// Finds what supports a chassis besides its wheels. Internal to sim/robot.
#pragma once

#include <set>
#include <string>

#include "sim/robot/urdf/robot_model.hpp"

namespace castaway::sim {

/// Sets `casters` of a robot whose parts and wheels are known, and removes their parts from its
/// collision shapes: balls, parts of links named caster, and parts of `swivels` (links on locked
/// joints) that reach within 1 cm of the floor. A robot on two wheels without casters gets one, and
/// a warning.
void find_casters(RobotModel& robot, const std::set<std::string>& swivels);

/// Moves the centre of mass to where wheels and casters support it, with a warning.
void balance(RobotModel& robot);

}  // namespace castaway::sim
