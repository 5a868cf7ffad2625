/// Stretches of a drive over which odometry is compared with the map.
#pragma once

#include <cstddef>
#include <vector>

#include "tools/twin/alignment/motion_samples.hpp"

namespace castaway::testbed {

/// Successive legs.
struct Stretch {
  std::vector<OdometryStep> steps;
  SE2 T_start_end;    ///< Of base, by the map.
  double way = 0.0;   ///< [m] Mean travel of the wheels.
  double turn = 0.0;  ///< [rad] Turned to either side.
  /// [m] Travel whose errors move the end along x and y of its frame.
  Eigen::Vector2d walk{0.0, 0.0};
  Eigen::Vector2d sway{0.0, 0.0};   ///< [m^3] The same for errors of the yaw by travel,
  Eigen::Vector2d swing{0.0, 0.0};  ///< [m^2 rad] and by turn.
  Eigen::Vector2d lever{0.0, 0.0};  ///< [m^2] The same for an error of the yaw at the start.
  /// [m^2/s^2] The same for errors of the stamps at both ends,
  Eigen::Vector2d speeds{0.0, 0.0};
  double turn_rates = 0.0;  ///< [rad^2/s^2] and of the yaw.
  std::size_t leg = 0;      ///< Index of the first leg.
};

/// Cuts legs into stretches in which the wheels travel `length` [m] or a little more; at breaks,
/// and where legs are much longer, nothing is taken.
std::vector<Stretch> take_stretches(const std::vector<Leg>& legs, double length);

/// Where corrected odometry ends, seen from where the map says that the stretch ends.
SE2 miss_of(const Stretch& stretch, const DriveErrors& errors);

}  // namespace castaway::testbed
