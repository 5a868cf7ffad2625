/// Velocity ramp with bounded acceleration, as in a drive's firmware.
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

/// `command` limited to the speed limits and to what `dt` [s] allows from `current`.
Twist2 ramp_twist(const Twist2& current, const Twist2& command, const TwistLimits& limits,
                  double dt);

}  // namespace castaway::sim
