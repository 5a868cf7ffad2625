/// Where worlds, robots and scenarios are found.
#pragma once

#include <filesystem>
#include <string>

namespace castaway::testbed {

/// The folder that holds `worlds/` and `robots/`: $CASTAWAY_DATA, or the source tree the program
/// was built from.
std::filesystem::path data_root();

/// A world's file: `text` itself if it exists (a folder means its world.yaml), else relative to
/// `base`, else
/// `<data>/worlds/<text>/world.yaml`. Throws std::runtime_error listing the worlds there are.
std::filesystem::path find_world(const std::string& text, const std::filesystem::path& base);

/// A robot's file: `text` itself if it exists (a folder means the .urdf, .urdf.xacro or .xacro in
/// it that bears its name), else relative to `base`, else `<data>/robots/<text>`. Throws
/// std::runtime_error listing the robots there are.
std::filesystem::path find_robot(const std::string& text, const std::filesystem::path& base);

}  // namespace castaway::testbed
