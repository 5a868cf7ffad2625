/// The events of a scenario, as YAML.
#pragma once

#include "tools/scenario/sections/scenario.hpp"
#include "tools/scenario/yaml/settings.hpp"

namespace castaway::testbed {

/// Reads the list `events` of `root`. Throws std::runtime_error for an invalid event.
EventSpecs read_events(YamlReader& root);

/// Appends the settings of every sort of events.
void describe_events(std::vector<SettingText>& texts);

}  // namespace castaway::testbed
