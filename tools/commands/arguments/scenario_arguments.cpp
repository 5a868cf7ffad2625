#include "tools/commands/arguments/scenario_arguments.hpp"

#include <stdexcept>

#include "tools/base/output/file_name.hpp"
#include "tools/commands/arguments/localizer_arguments.hpp"
#include "tools/scenario/files/data_paths.hpp"
#include "tools/scenario/scenario_name.hpp"

namespace castaway::testbed {
namespace {

void append(std::vector<std::string>& list, const std::vector<std::string>& more) {
  list.insert(list.end(), more.begin(), more.end());
}

}  // namespace

std::filesystem::path ScenarioArguments::file() const {
  if (scenario.empty()) return data_root() / "worlds/lab/scenarios/kidnap.yaml";
  if (scenario.find('=') != std::string::npos && !std::filesystem::exists(scenario)) {
    throw std::invalid_argument(
        scenario + ": is no scenario's file; every key=value takes a --set of its own");
  }
  return find_scenario(scenario, ".");
}

std::vector<std::string> ScenarioArguments::overrides() const {
  std::vector<std::string> overrides = shortcuts;
  append(overrides, localizer_override(localizers));
  append(overrides, robot_and_world_overrides(robot, world, robot_options));
  append(overrides, sets);
  if (!name.empty()) {
    overrides.push_back("name=" + quote_yaml(name));
  } else if (const auto derived = name_of_overridden(file(), overrides)) {
    overrides.push_back("name=" + quote_yaml(*derived));
  }
  return overrides;
}

std::string ScenarioArguments::label() const {
  std::vector<std::string> texts;
  for (const std::string& text : shortcuts) {
    if (!text.starts_with("seed=")) texts.push_back(text);
  }
  append(texts, localizers);
  append(texts, sets);
  return label_of(texts);
}

void add_scenario_options(Command command, ScenarioArguments& arguments) {
  command.add_option("--name", arguments.name, "Name of the run, its folder and its report")
      .check(file_name_error);
  command.add_option("--world", arguments.world, "A world's name or path, or a ROS map's .yaml")
      .check([](const std::string& text) {
        return text.empty() ? std::string("needs a world's name or path") : std::string();
      });
  command.add_option("--robot", arguments.robot, "A robot's name, a .urdf or a .xacro");
  add_robot_options(command, arguments.robot_options);
  command.add_option("--set", arguments.sets, "Override a key of the scenario: key=value")
      .repeatable();
  command
      .add_option("--localizer", arguments.localizers,
                  "NAME, NAME:PRESET, program:COMMAND or library:FILE instead of the scenario's; "
                  "repeat for several")
      .repeatable();
}

}  // namespace castaway::testbed
