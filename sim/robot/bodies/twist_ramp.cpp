#include "sim/robot/bodies/twist_ramp.hpp"

#include <algorithm>

namespace castaway::sim {
namespace {

double approach(double current, double target, double step) {
  return current + std::clamp(target - current, -step, step);
}

}  // namespace

Twist2 ramp_twist(const Twist2& current, const Twist2& command, const TwistLimits& limits,
                  double dt) {
  const double v = std::clamp(command.v, -limits.max_speed, limits.max_speed);
  const double w = std::clamp(command.w, -limits.max_turn_rate, limits.max_turn_rate);
  return {approach(current.v, v, limits.max_acceleration * dt),
          approach(current.w, w, limits.max_turn_acceleration * dt)};
}

}  // namespace castaway::sim
