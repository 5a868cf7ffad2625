/// Velocity commands as a drive's firmware follows them: with bounded acceleration.
#pragma once

#include "sim/common/geometry.hpp"

namespace castaway::sim {

/// Limits of a drive.
struct TwistLimits {
  double max_speed = 0.5;              ///< [m/s]
  double max_turn_rate = 1.0;          ///< [rad/s]
  double max_acceleration = 0.5;       ///< [m/s^2]
  double max_turn_acceleration = 2.0;  ///< [rad/s^2]
};

/// `command` within the limits of speed, and no further from `current` than `dt` [s] allows.
Twist2 ramped(const Twist2& current, const Twist2& command, const TwistLimits& limits, double dt);

}  // namespace castaway::sim
