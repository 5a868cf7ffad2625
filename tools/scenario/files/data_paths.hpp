/// Finds worlds, robots and scenarios.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace castaway::testbed {

/// The folder that holds `worlds/`, `robots/`, `lidars/`, `logs/` and `datasets/`: $CASTAWAY_DATA,
/// or the program's `share/castaway`, in the installation or in the build tree. Throws
/// std::runtime_error if it holds no worlds.
std::filesystem::path data_root();

/// Names the folder of `data_root` where the data lie elsewhere than beside the running program,
/// which is not castaway's own. $CASTAWAY_DATA still overrides it. Call it before all others.
void set_shipped_data(const std::filesystem::path& folder);

/// Finds a world's file: `text` itself if it exists (a folder means its world.yaml), else relative
/// to `base`, else `<data>/worlds/<text>/world.yaml`. Throws std::runtime_error listing the
/// available worlds.
std::filesystem::path find_world(const std::string& text, const std::filesystem::path& base);

/// Finds a robot's file: `text` itself if it exists (a folder means its .urdf, .urdf.xacro or
/// .xacro file of the same name), else relative to `base`, else `<data>/robots/<text>`. Throws
/// std::runtime_error listing the available robots.
std::filesystem::path find_robot(const std::string& text, const std::filesystem::path& base);

/// Finds a scenario's file: `text` itself, or relative to `base`, or
/// `<data>/worlds/<world>/scenarios/<name>.yaml` for "<world>/<name>". Throws std::runtime_error
/// with the nearest name.
std::filesystem::path find_scenario(const std::string& text, const std::filesystem::path& base);

/// `text` itself if it exists, else relative to `base`.
std::filesystem::path find_file(const std::string& text, const std::filesystem::path& base);

/// `text` itself if something is there, else its place among the data, such as "logs/office", if
/// something is there; else `text`.
std::string find_shipped(const std::string& text);

/// Sorted names of the shipped worlds, robots and scenarios.
std::vector<std::string> world_names();
std::vector<std::string> robot_names();
/// Such as "<world>/<name>".
std::vector<std::string> scenario_names();

}  // namespace castaway::testbed
