/// Options of every command that loads a robot.
#pragma once

#include <string>
#include <vector>

namespace castaway::testbed {

/// What the command line says about how a robot is read.
struct RobotArguments {
  std::vector<std::string> assignments;   ///< --arg name:=value
  std::vector<std::string> search_paths;  ///< --search-path FOLDER
};

/// Adds the two options. `arguments` must outlive the parsing.
void add_robot_options(Command command, RobotArguments& arguments);

/// Name and value of `name:=value`, as ROS writes it, or of `name=value`. Throws
/// std::invalid_argument naming the option.
std::pair<std::string, std::string> parse_assignment(const std::string& text);

/// What --set would say in the place of --robot, --arg and --search-path. `file` may be empty: the
/// scenario's.
std::vector<std::string> robot_overrides(const std::string& file, const RobotArguments& arguments);

}  // namespace castaway::testbed
