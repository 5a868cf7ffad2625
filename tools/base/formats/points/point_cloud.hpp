/// Point clouds from PCD and PLY files.
#pragma once

#include <filesystem>
#include <vector>

#include <Eigen/Core>

namespace castaway::testbed {

/// Reads the points of a PCD or PLY file, which is detected from its first bytes. Points that are
/// not finite are left out. Throws std::runtime_error naming the file, and the line where there is
/// one, if it cannot be read or is malformed.
std::vector<Eigen::Vector3d> read_point_cloud(const std::filesystem::path& file);

}  // namespace castaway::testbed
