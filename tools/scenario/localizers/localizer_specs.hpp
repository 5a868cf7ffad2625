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

}  // namespace castaway::testbed
