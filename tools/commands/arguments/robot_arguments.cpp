#include "tools/commands/arguments/robot_arguments.hpp"

#include <filesystem>
#include <stdexcept>

#include <fmt/format.h>

namespace castaway::testbed {
namespace {

/// "[a, b]" in YAML.
std::string list_of(const std::vector<std::string>& texts) {
  std::string list;
  for (const std::string& text : texts) list += (list.empty() ? "" : ", ") + quote_yaml(text);
  return "[" + list + "]";
}

bool is_sdf(std::filesystem::path file) {
  if (file.extension() == ".xacro") file = file.stem();
  return file.extension() == ".sdf" || file.extension() == ".world";
}

}  // namespace

std::string quote_yaml(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? "''" : std::string(1, c);
  return result + "'";
}

void add_robot_options(Command command, RobotArguments& arguments) {
  command
      .add_option("--arg", arguments.assignments, "Argument of the robot's xacro file: name:=value")
      .repeatable();
  command
      .add_option("--search-path", arguments.search_paths,
                  "Folder in which the robot's packages are searched (besides "
                  "CASTAWAY_PACKAGE_PATH, ROS_PACKAGE_PATH, AMENT_PREFIX_PATH)")
      .repeatable();
}

std::pair<std::string, std::string> parse_assignment(const std::string& text) {
  const std::size_t equals = text.find('=');
  std::string name = text.substr(0, equals);
  if (name.ends_with(':')) name.pop_back();
  if (equals == std::string::npos || name.empty()) {
    throw std::invalid_argument(fmt::format("--arg {}: write it as name:=value", text));
  }
  return {name, text.substr(equals + 1)};
}

std::vector<std::string> robot_overrides(const std::string& file, const RobotArguments& arguments) {
  std::vector<std::string> overrides;
  if (arguments.assignments.empty() && arguments.search_paths.empty()) {
    if (!file.empty()) overrides.push_back("robot=" + quote_yaml(file));
    return overrides;
  }
  if (file.empty()) {
    throw std::invalid_argument("--arg and --search-path go with --robot: name the robot's file");
  }
  std::string args;
  for (const std::string& text : arguments.assignments) {
    const auto [name, value] = parse_assignment(text);
    args += (args.empty() ? "" : ", ") + quote_yaml(name) + ": " + quote_yaml(value);
  }
  overrides.push_back(fmt::format("robot={{file: {}, args: {{{}}}, search_paths: {}}}",
                                  quote_yaml(file), args, list_of(arguments.search_paths)));
  return overrides;
}

std::vector<std::string> robot_and_world_overrides(const std::string& robot,
                                                   const std::string& world,
                                                   const RobotArguments& arguments) {
  RobotArguments of_robot = arguments;
  std::vector<std::string> overrides;
  if (!world.empty() && is_sdf(world) && !arguments.search_paths.empty()) {
    overrides.push_back(fmt::format("world={{name: {}, search_paths: {}}}", quote_yaml(world),
                                    list_of(arguments.search_paths)));
    if (robot.empty()) of_robot.search_paths.clear();
  } else if (!world.empty()) {
    overrides.push_back("world=" + world);
  }
  if (robot.empty() && !of_robot.search_paths.empty()) {
    throw std::invalid_argument(
        "--search-path: searches the packages of a --robot and the models of an SDF --world "
        "(.sdf, .world); name one, or leave the option away");
  }
  for (std::string& text : robot_overrides(robot, of_robot)) overrides.push_back(std::move(text));
  return overrides;
}

}  // namespace castaway::testbed
