/// Builds a robot from a scenario or a command line.
#pragma once

#include <filesystem>

#include "sim/robot/load_robot.hpp"
#include "sim/simulation.hpp"
#include "tools/build/foreign/message_text.hpp"
#include "tools/build/ros2/bridge_config.hpp"
#include "tools/scenario/sections/scenario.hpp"

namespace castaway::testbed {

/// Options for loading a robot: the specification's arguments, its search paths and a YAML reader.
/// Relative search paths start from `base`, or from the current folder if they do not exist there.
sim::RobotOptions robot_options(const RobotSpec& spec, const std::filesystem::path& base);

/// Finds and loads a robot. Throws std::runtime_error naming what is wrong.
sim::RobotModel build_robot(const RobotSpec& spec, const std::filesystem::path& base);

/// What nodes of ROS 2 are told about the robot that was built so.
RobotFacts robot_facts(const RobotSpec& spec, const std::filesystem::path& base,
                       const sim::RobotModel& robot);

/// Fills in what a bridge tells of the robot and its lidars.
void tell_robot(const RobotSpec& spec, const std::filesystem::path& base,
                const sim::SimulationConfig& config, BridgeConfig& bridge);

}  // namespace castaway::testbed
