/// What is simulated: a scenario's file with changes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace castaway {

/// A scenario with its changes, as `castaway run` takes them. It is read where it is used.
struct Scenario {
  std::string file = "lab/kidnap";     ///< A file, or <world>/<name> of one that comes along.
  std::vector<std::string> changes{};  ///< key=value, as `--set` takes them; later ones override.
  bool allow_programs = false;         ///< The file may name programs and libraries to be started.

  /// Changes a key of docs/scenarios.md, such as "lidar.range_max". `value`: YAML.
  Scenario& set(const std::string& key, const std::string& value) {
    changes.push_back(key + "=" + value);
    return *this;
  }
};

/// The scenario with all defaults filled in, as YAML. @throws std::runtime_error or
/// std::invalid_argument naming file, line and key, what is wrong and what to do.
std::string effective_text(const Scenario& scenario);

/// The scenarios that come along, such as "lab/kidnap".
std::vector<std::string> scenario_names();

/// Names the folder of worlds, robots and lidars of a program that has none in `share/castaway`
/// beside it; the environment variable CASTAWAY_DATA overrides it. Call it before all others.
void set_data_folder(const std::filesystem::path& folder);

}  // namespace castaway
