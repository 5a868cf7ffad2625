/// Jumps of a localizer's output.
#pragma once

#include <cstdint>
#include <vector>

#include "tools/run/metrics/recovery.hpp"

namespace castaway::testbed {

/// A change of the output beyond odometry is a jump if it exceeds one of these thresholds.
struct JumpConfig {
  double position_m = 0.2;  ///< [m]
  double yaw_rad = 0.2;     ///< [rad]
};

/// Jumps of the output between consecutive answers. A recovery necessarily counts as one.
struct OutputJumps {
  int count = 0;           ///< Number of all jumps.
  int while_tracking = 0;  ///< Jumps outside the times from a kidnap to its recovery.
  double largest_m = 0.0;  ///< [m] Largest change that odometry does not explain.
};

/// Finds the jumps: deviations of an answer from the previous one moved by odometry.
OutputJumps jumps_of(const std::vector<MetricRow>& rows, const std::vector<RecoveryWindow>& windows,
                     const JumpConfig& config = {});

}  // namespace castaway::testbed
