/// Worlds and robots that a page brings to a live run.
#pragma once

#include <filesystem>

#include "tools/scenario/scenario_file.hpp"

namespace castaway::testbed {

/// A scenario in the world of `file` (SDF, YAML of a world or of a ROS map), on a random route from
/// a random start: places of the old world, and events, are left out. Throws std::runtime_error if
/// it is no scenario.
LoadedScenario in_world(const LoadedScenario& scenario, const std::filesystem::path& file);

/// A scenario with the robot of `file` (URDF, xacro) and its own lidars; events are left out.
/// Throws std::runtime_error if it is no scenario.
LoadedScenario with_robot(const LoadedScenario& scenario, const std::filesystem::path& file);

/// The scenario in or with `file`, by its name: *.urdf and *.xacro (unless *.world.xacro and
/// *.sdf.xacro) are robots, *.sdf, *.world and *.yaml worlds. Throws std::runtime_error for others,
/// and if there is no such file.
LoadedScenario with_file(const LoadedScenario& scenario, const std::filesystem::path& file);

}  // namespace castaway::testbed
