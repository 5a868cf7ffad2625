/// Reads localizers from YAML and from the command line.
#pragma once

#include <string>
#include <vector>

#include "tools/scenario/localizers/foreign_yaml.hpp"
#include "tools/scenario/sections/scenario.hpp"
#include "tools/scenario/yaml/settings.hpp"

namespace castaway::testbed {

/// Appends the settings of all localizers.
void describe_localizers(std::vector<SettingText>& texts);

/// Reads the list of localizers under `key`: names, or maps of one name to its settings. `[]` means
/// none; a missing list is an error.
std::vector<LocalizerSpec> read_localizers(YamlReader& root, const std::string& key,
                                           const ForeignRules& rules = {});

/// True if a text of the command line is a YAML file with a list `localizers`.
bool names_a_file(const std::string& text);

/// Parses a localizer from the command line: `mh_amcl`, `amcl:amcl-recovery`,
/// `program:python3 mine.py`, `library:./libmine.so`.
LocalizerSpec parse_localizer(const std::string& text);

/// The text of a localizer on the command line as an element of a scenario's list, in YAML. Throws
/// std::invalid_argument.
std::string localizer_yaml(const std::string& text);

/// True for `mh_amcl` in mode 3d.
bool is_on_map3d(const LocalizerSpec& spec);

/// Parses several localizers; a text that ends with .yaml or .yml is a file with a list
/// `localizers`, as in a scenario. Throws std::runtime_error (`YamlDocument`) or
/// std::invalid_argument; two localizers of one name are an error.
std::vector<LocalizerSpec> parse_localizers(const std::vector<std::string>& texts,
                                            FilePrograms programs = FilePrograms::kRefused);

}  // namespace castaway::testbed
