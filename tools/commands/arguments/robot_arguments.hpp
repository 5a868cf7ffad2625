/// Options of all commands that load a robot.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tools/commands/arguments/command_line.hpp"

namespace castaway::testbed {

/// Options for loading a robot.
struct RobotArguments {
  std::vector<std::string> assignments;   ///< --arg name:=value
  std::vector<std::string> search_paths;  ///< --search-path FOLDER
};

/// Adds the two options. `arguments` must outlive the parsing.
void add_robot_options(Command command, RobotArguments& arguments);

/// A text as a string of YAML.
std::string quote_yaml(const std::string& text);

/// Splits `name:=value`, as in ROS, or `name=value`. Throws std::invalid_argument naming the
/// option.
std::pair<std::string, std::string> parse_assignment(const std::string& text);

/// Overrides, as for --set, that are equivalent to --robot, --arg and --search-path. If `file` is
/// empty, the scenario's robot is used.
std::vector<std::string> robot_overrides(const std::string& file, const RobotArguments& arguments);

/// As `robot_overrides`, with --world: an SDF world's models are searched in --search-path, too.
/// Without --robot, the option is for the world alone. Throws std::invalid_argument if neither
/// takes it.
std::vector<std::string> robot_and_world_overrides(const std::string& robot,
                                                   const std::string& world,
                                                   const RobotArguments& arguments);

}  // namespace castaway::testbed
