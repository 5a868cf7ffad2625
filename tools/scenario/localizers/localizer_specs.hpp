/// Reads localizers from YAML and from the command line.
#pragma once

#include <string>
#include <vector>

#include "tools/scenario/sections/scenario.hpp"
#include "tools/scenario/yaml/settings.hpp"

namespace castaway::testbed {

/// Appends the settings of all localizers.
void describe_localizers(std::vector<SettingText>& texts);

/// Reads the list of localizers under `key`: names, or maps of one name to its settings. `[]` means
/// none; a missing list is an error.
std::vector<LocalizerSpec> read_localizers(YamlReader& root, const std::string& key);

/// Parses a localizer from the command line: `mh_amcl`, `amcl`, `amcl:amcl-recovery`.
LocalizerSpec parse_localizer(const std::string& text);

/// The same of several; a text that ends with .yaml or .yml is a file with a list `localizers`, as
/// in a scenario. Throws std::runtime_error (`YamlDocument`) or std::invalid_argument; two
/// localizers of one name are an error.
std::vector<LocalizerSpec> parse_localizers(const std::vector<std::string>& texts);

}  // namespace castaway::testbed
