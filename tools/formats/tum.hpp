/// Trajectories in TUM format: `timestamp tx ty tz qx qy qz qw` a line.
#pragma once

#include <chrono>
#include <string>

#include "localization/geometry/se2.hpp"

namespace castaway::testbed {

/// A pose of base in map at a time.
struct StampedPose {
  std::chrono::nanoseconds stamp{};
  localization::SE2 T_map_base;
};

/// One line with its newline: seconds with 9 digits, metres and quaternion with 9 digits.
std::string tum_line(const StampedPose& pose);

}  // namespace castaway::testbed
