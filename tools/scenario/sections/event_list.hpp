/// The events of a scenario, as YAML.
#pragma once

#include "tools/scenario/sections/scenario.hpp"
#include "tools/scenario/yaml/yaml_reader.hpp"

namespace castaway::testbed {

/// Reads the list `events` of `root`. Throws std::runtime_error for an invalid event.
EventSpecs read_events(YamlReader& root);

}  // namespace castaway::testbed
