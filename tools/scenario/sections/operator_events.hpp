/// What an operator does during a run, as YAML: drives the robot, restarts localizers.
#pragma once

#include "sim/events/drive_command.hpp"
#include "tools/run/localizer_order.hpp"
#include "tools/scenario/yaml/settings.hpp"

namespace castaway::testbed {

/// Settings of `- drive: {...}`.
void fields(Settings settings, sim::DriveCommand& command);
/// Settings of `- localizer: {...}`.
void fields(Settings settings, LocalizerOrder& order);

/// Read the bodies. Throw std::runtime_error for an invalid value.
sim::DriveCommand read_drive_command(YamlReader body);
LocalizerOrder read_localizer_order(YamlReader body);

}  // namespace castaway::testbed
