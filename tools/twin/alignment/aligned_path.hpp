/// The path of an aligned log.
#pragma once

#include <vector>

#include "tools/twin/alignment/aligned_log.hpp"

namespace castaway::testbed {

/// A pose of base on the map.
struct PathPose {
  Stamp stamp{};
  SE2 T_map_base;
};

/// The poses of the aligned scans, and between them, at least every 0.1 s, poses along the measured
/// odometry, bent so that it ends at the next scan. Stamps increase.
std::vector<PathPose> path_of(const AlignedLog& log);

/// Times since the first aligned scan of all scans up to the last, those left out, too; ascending.
std::vector<Stamp> played_times(const AlignedLog& log);

}  // namespace castaway::testbed
