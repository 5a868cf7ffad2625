/// Where worlds, robots and scenarios are found.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace castaway::testbed {

/// The folder that holds `worlds/`, `robots/`, `lidars/` and `datasets/`: $CASTAWAY_DATA, or
/// `share/castaway` by the program, installed or in its build tree. @throws std::runtime_error
/// if it holds no worlds.
std::filesystem::path data_root();

/// A world's file: `text` itself if it exists (a folder means its world.yaml), else relative to
/// `base`, else
/// `<data>/worlds/<text>/world.yaml`. Throws std::runtime_error listing the worlds there are.
std::filesystem::path find_world(const std::string& text, const std::filesystem::path& base);

/// A robot's file: `text` itself if it exists (a folder means the .urdf, .urdf.xacro or .xacro in
/// it that bears its name), else relative to `base`, else `<data>/robots/<text>`. Throws
/// std::runtime_error listing the robots there are.
std::filesystem::path find_robot(const std::string& text, const std::filesystem::path& base);

/// A scenario's file: `text` itself, or relative to `base`, or
/// `<data>/worlds/<world>/scenarios/<name>.yaml` of "<world>/<name>". Throws std::runtime_error
/// with the nearest name.
std::filesystem::path find_scenario(const std::string& text, const std::filesystem::path& base);

/// Names of what comes along, in order.
std::vector<std::string> world_names();
std::vector<std::string> robot_names();
/// "<world>/<name>"
std::vector<std::string> scenario_names();

}  // namespace castaway::testbed
