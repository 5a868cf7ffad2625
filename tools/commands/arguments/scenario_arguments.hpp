/// Options of the commands that play a scenario.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/commands/arguments/command_line.hpp"
#include "tools/commands/arguments/robot_arguments.hpp"

namespace castaway::testbed {

/// A scenario and what the command line changes in it.
struct ScenarioArguments {
  std::string scenario;  ///< Empty: lab/kidnap.
  std::string name;      ///< Empty: `name_of_overridden`, or the scenario's.
  std::string world;     ///< Empty: the scenario's.
  std::string robot;     ///< Empty: the scenario's.
  RobotArguments robot_options;
  std::vector<std::string> shortcuts;   ///< --seed and the like, as key=value.
  std::vector<std::string> sets;        ///< --set key=value
  std::vector<std::string> localizers;  ///< Replace the scenario's.

  /// The scenario's file. Throws std::invalid_argument or std::runtime_error if there is none.
  [[nodiscard]] std::filesystem::path file() const;
  /// All of it as key=value, for `load_scenario`, with the run's name.
  [[nodiscard]] std::vector<std::string> overrides() const;
  /// What tells the run from others of its scenario, robot and world (`label_of`).
  [[nodiscard]] std::string label() const;
};

/// Adds --name, --world, --robot, --arg, --search-path, --set and --localizer. `arguments` must
/// outlive the parsing.
void add_scenario_options(Command command, ScenarioArguments& arguments);

}  // namespace castaway::testbed
