/// What the robot's sensors deliver, and the truth beside it.
#pragma once

#include <chrono>
#include <vector>

#include "sim/geometry.hpp"

namespace castaway::sim {

/// One reading of wheel odometry.
struct OdometryReading {
  std::chrono::nanoseconds stamp{};
  Pose2 T_odom_base;  ///< Accumulated from the start of the run; continuous, drifting.
  Pose2 T_map_base_true;
};

/// What a beam hit, besides the index of an object in `WorldSpec::objects`.
inline constexpr int kHitNothing = -1;
inline constexpr int kHitFloor = -2;

/// One scan.
struct LidarReading {
  std::chrono::nanoseconds stamp{};           ///< Of the first beam.
  std::chrono::nanoseconds time_increment{};  ///< Between two beams; 0 without sweep.
  std::vector<float> ranges;                  ///< [m] +inf: nothing within range, -inf: too close.
  std::vector<int> hit_object;  ///< Same length: index of the object, or kHitNothing, kHitFloor.
  Pose2 T_map_base_true;        ///< At the stamp.
};

}  // namespace castaway::sim
