/// Finds the MCAP files of a bag.
#pragma once

#include <filesystem>
#include <vector>

namespace castaway::testbed {

/// True if a path is a bag rather than a CARMEN log: a folder, an .mcap, .db3 or .bag file.
bool is_bag(const std::filesystem::path& path);

/// The files of a bag in order: the .mcap file itself, the files named in the folder's
/// metadata.yaml, or without that file all *.mcap of the folder, sorted by name. Throws
/// std::runtime_error naming the remedy if there are none, if they are of another format (sqlite3,
/// ROS 1), or if they are compressed as whole files.
std::vector<std::filesystem::path> bag_files(const std::filesystem::path& path);

}  // namespace castaway::testbed
