/// Motion between aligned scans, by odometry and by the map.
#pragma once

#include <vector>

#include "tools/twin/alignment/aligned_log.hpp"
#include "tools/twin/alignment/odometry_step.hpp"

namespace castaway::testbed {

/// How fast odometry changes.
struct OdometryRate {
  double along = 0.0;  ///< [m/s]
  double turn = 0.0;   ///< [rad/s]
};

/// Motion from one aligned scan to the next.
struct Leg {
  std::vector<OdometryStep> steps;
  SE2 T_start_end;      ///< Of base, by the map.
  double way = 0.0;     ///< [m] Mean travel of the wheels.
  bool breaks = false;  ///< The motion is unknown.
  OdometryRate rate_at_start;
  OdometryRate rate_at_end;
};

/// The legs between the scans of a log, one less than scans. Odometry is split into steps of at
/// most 0.1 s. `track` [m] is the distance between the wheels.
std::vector<Leg> take_legs(const AlignedLog& log, double track);

}  // namespace castaway::testbed
