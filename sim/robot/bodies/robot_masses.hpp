/// Masses of a robot's wheels and chassis. Internal to sim/robot.
#pragma once

#include "sim/robot/urdf/urdf_parts.hpp"

namespace castaway::sim {

/// Sets the masses of a robot whose wheels and parts are known. Links without <inertial> weigh
/// nothing (many files put the whole mass into one link). If that makes the chassis lighter than
/// the wheels, the masses of these links are guessed from their shapes, with a warning.
/// @throws std::runtime_error if there are only wheels.
void add_masses(const UrdfFile& file, const LinkFrames& frames, RobotModel& robot);

/// [N] Load of a driven wheel if all wheels carry the same and nothing else carries: the robot's
/// weight divided by their number.
double wheel_load(const RobotModel& robot);

}  // namespace castaway::sim
