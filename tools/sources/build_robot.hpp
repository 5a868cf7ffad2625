/// A robot from what a scenario or a command line says of it.
#pragma once

#include <filesystem>

#include "sim/robot/load_robot.hpp"
#include "tools/scenario/sections/scenario.hpp"

namespace castaway::testbed {

/// What the simulator reads a robot with: the specification's arguments and search paths (relative
/// ones from `base`, or from the current folder where they are not there), and a reader of YAML.
sim::RobotOptions robot_options(const RobotSpec& spec, const std::filesystem::path& base);

/// Finds and loads a robot. Throws std::runtime_error naming what is wrong.
sim::RobotModel build_robot(const RobotSpec& spec, const std::filesystem::path& base);

}  // namespace castaway::testbed
