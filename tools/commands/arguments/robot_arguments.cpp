#include "tools/commands/arguments/robot_arguments.hpp"

#include <stdexcept>

#include <fmt/format.h>

namespace castaway::testbed {
namespace {

/// Quotes a text as a YAML string.
std::string quote_yaml(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? "''" : std::string(1, c);
  return result + "'";
}

}  // namespace

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
  std::string paths;
  for (const std::string& path : arguments.search_paths) {
    paths += (paths.empty() ? "" : ", ") + quote_yaml(path);
  }
  overrides.push_back(fmt::format("robot={{file: {}, args: {{{}}}, search_paths: [{}]}}",
                                  quote_yaml(file), args, paths));
  return overrides;
}

}  // namespace castaway::testbed
