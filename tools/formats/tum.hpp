/// Trajectories in TUM format: lines of `timestamp tx ty tz qx qy qz qw`.
#pragma once

#include <chrono>
#include <string>

#include "localization/geometry/se2.hpp"

namespace castaway::testbed {

/// A pose of base in map with its time.
struct StampedPose {
  std::chrono::nanoseconds stamp{};
  localization::SE2 T_map_base;
};

/// One line with its newline; seconds, metres and quaternion with 9 decimal places.
std::string tum_line(const StampedPose& pose);

}  // namespace castaway::testbed
