/// Drift of odometry relative to the true path.
#pragma once

#include <optional>
#include <vector>

#include "tools/build/recorded/recorded_source.hpp"

namespace castaway::testbed {

/// Error of a segment of a trajectory: relative motion by odometry against true relative motion.
struct DriftSegment {
  double percent = 0.0;    ///< Position error at the end, as a percentage of the length.
  double deg_per_m = 0.0;  ///< Absolute yaw error at the end, divided by the length.
};

/// Segments of `length_m` [m] of true path, one starting at each metre. A kidnap discards the
/// segments that contain it.
std::vector<DriftSegment> drift_segments(const Frames& frames, double length_m);

/// Means over the segments; nothing if there are none.
std::optional<DriftSegment> mean_drift(const std::vector<DriftSegment>& segments);

}  // namespace castaway::testbed
