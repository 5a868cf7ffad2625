/// What carries a chassis besides its wheels. Internal to sim/robot.
#pragma once

#include <set>
#include <string>

#include "sim/robot/urdf/robot_model.hpp"

namespace castaway::sim {

/// Fills `casters` of a robot whose parts and wheels are known, and takes their parts off its
/// collisions: balls, parts of links named caster, and of `swivels` (links on locked joints) that
/// come within 1 cm of the floor. A robot on two wheels without any gets one, and a warning.
void find_casters(RobotModel& robot, const std::set<std::string>& swivels);

/// Moves the centre of mass to where wheels and casters carry it, with a warning.
void balance(RobotModel& robot);

}  // namespace castaway::sim
