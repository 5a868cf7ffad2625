/// How far odometry drifts from the truth.
#pragma once

#include <optional>
#include <vector>

#include "tools/sources/recorded_source.hpp"

namespace castaway::testbed {

/// A segment of a trajectory: relative motion by odometry against relative motion in truth.
struct DriftSegment {
  double percent = 0.0;    ///< Position error at its end, of its length.
  double deg_per_m = 0.0;  ///< Yaw error at its end, over its length, without sign.
};

/// Segments of `length_m` of true path, one from each metre on; a kidnap ends all that it is in.
std::vector<DriftSegment> drift_segments(const Frames& frames, double length_m);

/// Means over segments; nothing where there are none.
std::optional<DriftSegment> mean_drift(const std::vector<DriftSegment>& segments);

}  // namespace castaway::testbed
