/// Worlds, robots and logs that a page brings to a live run.
#pragma once

#include <filesystem>

#include "tools/live/live_player.hpp"
#include "tools/scenario/scenario_file.hpp"

namespace castaway::testbed {

/// A scenario in the world of `file` (SDF, YAML of a world or of a ROS map), on a random route from
/// a random start: places of the old world, and events, are left out. Throws std::runtime_error if
/// it is no scenario.
LoadedScenario in_world(const LoadedScenario& scenario, const std::filesystem::path& file);

/// A scenario with the robot of `file` (URDF, xacro) and its own lidars; events are left out.
/// Throws std::runtime_error if it is no scenario.
LoadedScenario with_robot(const LoadedScenario& scenario, const std::filesystem::path& file);

/// The setup with a file of `setup.files`, by its name: *.urdf and *.xacro (unless *.world.xacro
/// and *.sdf.xacro) are robots, *.sdf, *.world and *.yaml worlds, *.log, *.log.gz, *.carmen,
/// *.carmen.gz and *.mcap recorded logs. `map`: of such a log, a *.yaml; empty: its own, or that of
/// the log that is played now. Throws std::runtime_error for others, and if there is no such file.
LiveSetup with_file(const LiveSetup& setup, const std::string& file, const std::string& map);

}  // namespace castaway::testbed
