/// The twin of a log as a scenario: the models that were fitted to it, and the path that it drove.
#pragma once

#include <string>

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

/// Fragments of a scenario in YAML. A model that the log cannot tell is ideal in the twin.
std::string lidar_text(const FittedLog& fitted);
std::string odometry_text(const FittedLog& fitted);
std::string people_text(int count);
/// Objects that are not on the map, as `differences`; empty text if there are none.
std::string differences_text(const FittedLog& fitted);

/// A scenario of the map `map.yaml` and the path `path.tum` beside it, as `castaway run` plays it.
std::string twin_scenario(const FittedLog& fitted, int people);

/// The poses of the axle in TUM format, with times since the first scan.
std::string path_text(const FittedLog& fitted);

/// The times at which the twin's scans begin, since the first one.
std::string scan_times_text(const AlignedLog& log);

}  // namespace castaway::testbed
