/// The MCAP files of a bag.
#pragma once

#include <filesystem>
#include <vector>

namespace castaway::testbed {

/// True if a path is a bag rather than a log: a folder, an .mcap, .db3 or .bag file.
bool is_bag(const std::filesystem::path& path);

/// The files of a bag in order: an .mcap file itself, those that a folder's metadata.yaml names, or
/// all *.mcap of a folder without one, by name. Throws std::runtime_error naming the remedy where
/// there is none, where they are of another kind (sqlite3, ROS 1), or compressed as whole files.
std::vector<std::filesystem::path> bag_files(const std::filesystem::path& path);

}  // namespace castaway::testbed
