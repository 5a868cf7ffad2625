/// Measures the drift of the odometry profiles in simulated runs.
#pragma once

#include <string>
#include <vector>

#include "tests/bench/workbench/odometry_drift.hpp"

namespace castaway::testbed {

struct OdometryBenchConfig {
  int seeds = 8;              ///< Number of robots, each with its own calibration.
  double duration_s = 300.0;  ///< [s] Per robot.
  double length_m = 10.0;     ///< [m] Length of a segment.
};

/// Drift segments of all robots of a profile on the lab's loop.
std::vector<DriftSegment> simulated_drift(const std::string& profile,
                                          const OdometryBenchConfig& config);

}  // namespace castaway::testbed
