/// Misses of odometry beside what the fitted noise predicts.
#pragma once

#include <vector>

#include "tools/twin/odometry/odometry_noise.hpp"

namespace castaway::testbed {

/// Stretches with similar turns or speeds.
struct MissBin {
  double at = 0.0;        ///< Mean turn [rad] or speed [m/s].
  double measured = 0.0;  ///< Standard deviation by the median: [rad] or [m].
  double model = 0.0;     ///< The same that the noise predicts.
};

/// Misses of the yaw by turn.
std::vector<MissBin> yaw_by_turn(const std::vector<Stretch>& stretches, const DriveErrors& errors,
                                 const OdometryNoise& noise);

/// Misses along the heading by the speed at both ends.
std::vector<MissBin> along_by_speed(const std::vector<Stretch>& stretches,
                                    const DriveErrors& errors, const OdometryNoise& noise);

}  // namespace castaway::testbed
