/// How steady an output is: where it leaps.
#pragma once

#include <cstdint>
#include <vector>

#include "tools/metrics/recovery.hpp"

namespace castaway::testbed {

/// From when on a change of the output that odometry does not account for is a jump.
struct JumpConfig {
  double position_m = 0.2;  ///< [m]
  double yaw_rad = 0.2;     ///< [rad]
};

/// Jumps of the output from one answer to the next. A recovery is one: it must be.
struct OutputJumps {
  int count = 0;           ///< All of them...
  int while_tracking = 0;  ///< ...and those outside of the times from a kidnap to its recovery.
  double largest_m = 0.0;  ///< [m] Of all changes that odometry does not account for.
};

/// What is expected of the next answer is the answer before, moved as odometry moved meanwhile.
OutputJumps jumps_of(const std::vector<MetricRow>& rows, const std::vector<RecoveryWindow>& windows,
                     const JumpConfig& config = {});

}  // namespace castaway::testbed
