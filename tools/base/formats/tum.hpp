/// Trajectories in TUM format: lines of `timestamp tx ty tz qx qy qz qw`.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "localization/geometry/se2.hpp"

namespace castaway::testbed {

/// A pose of base in map with its time.
struct StampedPose {
  std::chrono::nanoseconds stamp{};
  localization::SE2 T_map_base;
};

/// Reads poses, in order of time. z, roll and pitch are dropped. Throws std::runtime_error
/// "file:line: ..." on a malformed line, or if the file has no pose or its times do not increase.
std::vector<StampedPose> read_tum(const std::filesystem::path& path);

/// One line with its newline; seconds, metres and quaternion with 9 decimal places.
std::string tum_line(const StampedPose& pose);
/// The same with height, roll and pitch.
std::string tum_line(std::chrono::nanoseconds stamp, const Eigen::Isometry3d& T_map_base);

}  // namespace castaway::testbed
