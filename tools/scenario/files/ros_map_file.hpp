/// Loads a ROS map by its YAML file.
#pragma once

#include <filesystem>

#include "tools/base/formats/ros_map.hpp"

namespace castaway::testbed {

/// Throws std::runtime_error with a hint if the path ends like an image file instead of a YAML
/// file.
void refuse_picture(const std::filesystem::path& path);

/// Reads a map and its image (path relative to the YAML file). The map is named after the file's
/// stem, or after its folder if the stem is "map". Throws std::runtime_error naming the file, the
/// key and the remedy. Keys of other tools are ignored.
RosMap load_ros_map(const std::filesystem::path& yaml_path);

}  // namespace castaway::testbed
