/// Outputs of a run, as YAML.
#pragma once

#include "tools/scenario/sections/scenario.hpp"
#include "tools/scenario/yaml/settings.hpp"

namespace castaway::testbed {

/// Describes the settings under `outputs`.
void describe_outputs(Settings settings);

/// Reads `outputs`; every key has a default.
OutputSpec read_outputs(YamlReader& root);

}  // namespace castaway::testbed
