/// The commands of `workbench`, the program of the project's own measurements.
#pragma once

#include "tools/base/output/exit_code.hpp"
#include "tools/commands/arguments/command_line.hpp"

namespace castaway::testbed {

/// Adds a command, as those of tools/commands/commands.hpp.
void add_crowds_command(Command& app);
void add_odometry_command(Command& app);
void add_physics_command(Command& app);
void add_published_command(Command& app);

}  // namespace castaway::testbed
