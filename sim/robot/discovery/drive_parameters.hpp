/// Reads parameters of ros2_control's drive controllers. Internal to sim/robot.
#pragma once

#include "sim/robot/discovery/drive_tags.hpp"

namespace castaway::sim {

/// Adds joints, separation and radius from the first dictionary in a parameter file, at any depth,
/// that has `left_wheel_names` (ROS 1: `left_wheel`) or `wheel_separation`. Values that `tags`
/// already has are kept.
void add_drive_parameters(const xacro::Value& parameters, DriveTags& tags);

/// Adds the types of all controllers in a parameter file.
void add_controller_types(const xacro::Value& parameters, DriveTags& tags);

}  // namespace castaway::sim
