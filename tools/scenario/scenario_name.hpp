/// Names a scenario by what is played when the command line replaces its world or robot.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace castaway::testbed {

/// The name of `scenario` (a file) under the overrides: nothing if they leave its world and robot
/// as they are or set `name`. Otherwise `<world>-<scenario>` of another world, `<robot>-on-` before
/// it of another robot: lab/kidnap becomes `burger-on-map-kidnap` with `world=map.yaml` and
/// `robot=burger.urdf`. Worlds and robots are named by their files; model.sdf and model.urdf, as
/// Gazebo calls them all, by their folders. Throws as `load_scenario` does on unreadable files.
std::optional<std::string> name_of_overridden(const std::filesystem::path& scenario,
                                              const std::vector<std::string>& overrides);

/// What tells a run from others of its scenario, for the name of its folder: the overrides as
/// `key-value`, joined by `,`, without those that take others than letters, digits and `-_.,+`.
/// Empty if none is left or that takes more than 60 characters.
std::string label_of(const std::vector<std::string>& overrides);

}  // namespace castaway::testbed
