/// People as YAML.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tools/scenario/sections/scenario.hpp"
#include "tools/scenario/yaml/settings.hpp"

namespace castaway::testbed {

/// Behaviours by name; "mixed": nothing.
std::vector<std::pair<std::string, std::optional<sim::Behaviour>>> behaviours();

/// The settings under `people`.
void fields(Settings settings, PeopleSpec& people);

/// Reads `people`. Without the key there are none, and no defaults are filled in.
PeopleSpec read_people(YamlReader& root);

}  // namespace castaway::testbed
