/// The drift of the odometry profiles in simulated runs.
#pragma once

#include <string>
#include <vector>

#include "tools/bench/odometry_drift.hpp"

namespace castaway::testbed {

/// What is driven.
struct OdometryBenchConfig {
  int seeds = 8;              ///< Robots, each with its own calibration.
  double duration_s = 300.0;  ///< [s] Each.
  double length_m = 10.0;     ///< [m] Of a segment.
};

/// Segments of all robots of a profile on the lab's loop.
std::vector<DriftSegment> simulated_drift(const std::string& profile,
                                          const OdometryBenchConfig& config);

}  // namespace castaway::testbed
