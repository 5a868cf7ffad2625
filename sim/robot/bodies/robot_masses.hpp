/// Masses of a robot's wheels and chassis. Internal to sim/robot.
#pragma once

#include "sim/robot/urdf/urdf_parts.hpp"

namespace castaway::sim {

/// Fills the masses of a robot whose wheels and parts are known. Links without <inertial> weigh
/// nothing (many files keep the whole mass in one link); where that leaves a chassis lighter than
/// its wheels, they weigh what their shapes suggest, with a warning.
/// @throws std::runtime_error if there is nothing but wheels.
void add_masses(const UrdfFile& file, const LinkFrames& frames, RobotModel& robot);

/// [N] What a driven wheel carries where they carry alike, and nothing else carries: the robot's
/// weight by their number.
double wheel_load(const RobotModel& robot);

}  // namespace castaway::sim
