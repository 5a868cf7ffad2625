/// The twin of a log as a scenario: the models that were fitted to it, and the path that it drove.
#pragma once

#include <string>

#include "tools/twin/twin_motion.hpp"

namespace castaway::testbed {

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
