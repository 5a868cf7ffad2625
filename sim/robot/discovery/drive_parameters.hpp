/// Parameters of drive controllers of ros2_control. Internal to sim/robot.
#pragma once

#include "sim/robot/discovery/drive_tags.hpp"

namespace castaway::sim {

/// Adds joints, separation and radius of the first map in a parameter file, however deep, that
/// holds `left_wheel_names` (or ROS 1's `left_wheel`) or `wheel_separation`; what `tags` already
/// say stays.
void add_drive_parameters(const xacro::Value& parameters, DriveTags& tags);

}  // namespace castaway::sim
