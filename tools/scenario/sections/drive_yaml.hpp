/// Start and drive of a robot, as YAML.
#pragma once

#include "tools/scenario/sections/scenario.hpp"
#include "tools/scenario/yaml/settings.hpp"

namespace castaway::testbed {

/// The settings under `start` and `drive`.
void fields(Settings settings, StartSpec& start);
void fields(Settings settings, DriveSpec& drive);

/// Reads `start`: `unknown` or a map.
StartSpec read_start(YamlReader& root);

DriveSpec read_drive(YamlReader& root);

}  // namespace castaway::testbed
