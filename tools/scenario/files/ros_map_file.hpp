/// Loading a ROS map by its YAML file.
#pragma once

#include <filesystem>

#include "tools/formats/ros_map.hpp"

namespace castaway::testbed {

/// Says of a path that ends as pictures do what is missing. @throws std::runtime_error that does.
void refuse_picture(const std::filesystem::path& path);

/// Reads a map and its picture (path relative to the YAML file). The map's name is that of the
/// file's folder, or the file's stem where that is not "map". Throws std::runtime_error naming the
/// file, the key and the remedy. Keys of other tools are ignored.
RosMap load_ros_map(const std::filesystem::path& yaml_path);

}  // namespace castaway::testbed
