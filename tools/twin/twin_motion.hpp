/// How the robot of a twin follows a log.
#pragma once

#include "tools/twin/log_fit.hpp"

namespace castaway::testbed {

/// The robot of a twin, and the distance between its wheels.
inline constexpr const char* kTwinRobot = "disc";
inline constexpr double kTwinTrack = 0.233;  // [m]

/// How the twin follows the log.
struct TwinMotion {
  double axle_m = 0.0;      ///< [m] Odometry's frame is this far ahead of the wheels' axle.
  double duration_s = 0.0;  ///< [s] From the first aligned scan to the last one.
};

/// The log's motion. The axle is where odometry's sideways motion vanishes when the robot turns.
TwinMotion motion_of(const AlignedLog& log);

/// Pose of the middle of the wheels' axle in base, which the stated mount of the lidar defines.
SE2 axle_in_base(const FittedLog& fitted);

}  // namespace castaway::testbed
