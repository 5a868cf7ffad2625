/// Reads scenarios from YAML.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "tools/scenario/localizers/localizer_specs.hpp"
#include "tools/scenario/sections/scenario.hpp"
#include "tools/scenario/yaml/settings.hpp"

namespace castaway::testbed {

/// A scenario with the text that reproduces it.
struct LoadedScenario {
  Scenario scenario;
  std::string effective;  ///< YAML with all defaults filled in.
};

/// Reads a scenario file after applying `key=value` overrides. Throws std::runtime_error or
/// std::invalid_argument naming file, line, key, value and remedy. An unknown key is an error that
/// names the nearest known one.
LoadedScenario load_scenario(const std::filesystem::path& file,
                             const std::vector<std::string>& overrides,
                             FilePrograms programs = FilePrograms::kRefused);

/// Reads a scenario from a document. `folder`: where its relative paths start. `name`: its name if
/// it states none. Throws as `load_scenario` does.
LoadedScenario read_scenario(YamlDocument document, const std::filesystem::path& folder,
                             const std::string& name,
                             FilePrograms programs = FilePrograms::kRefused);

/// Every setting of a scenario, in the order of the documentation.
std::vector<SettingText> scenario_settings();

}  // namespace castaway::testbed
