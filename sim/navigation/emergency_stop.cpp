#include "sim/navigation/emergency_stop.hpp"

#include <algorithm>
#include <cmath>

namespace castaway::sim {
namespace {

// [m] An obstacle this close to the footprint where it would stop is a danger.
constexpr double kStopRoom = 0.01;
// [s] After braking, the robot stands still for at least this long.
constexpr double kStopPause = 0.5;
constexpr double kStopFrom = 0.15;  // [m/s] Stopping from a lower speed is not an emergency.

/// What happens if the robot brakes now.
struct Braking {
  double side = 1.0;      ///< -1 if it drives backwards.
  double duration = 0.0;  ///< [s]
  Eigen::Vector2d stop;   ///< [m] Where it stops, in base.
};

Braking braking_from(const Twist2& now, double deceleration) {
  const double speed = std::abs(now.v);
  const double side = now.v >= 0.0 ? 1.0 : -1.0;
  const double duration = speed / deceleration;
  const double way = 0.5 * speed * duration;
  const double turn = speed > 0.0 ? now.w / speed * way : 0.0;
  return {side, duration, arc(side * way, turn).position()};
}

}  // namespace

EmergencyStop::Order EmergencyStop::watch(const Twist2& now,
                                          const std::vector<Eigen::Vector2d>& p_base,
                                          const VelocityAt& velocity_at) {
  const Braking braking = braking_from(now, config_.deceleration);
  const double reach = config_.radius + kStopRoom;
  const bool danger = std::any_of(p_base.begin(), p_base.end(), [&](const Eigen::Vector2d& p) {
    // An obstacle that moves away is tested where it will be when the robot has stopped.
    const Eigen::Vector2d v = velocity_at(p);
    const Eigen::Vector2d then = v.dot(p) > 0.0 ? Eigen::Vector2d(p + braking.duration * v) : p;
    return braking.side * p.x() > 0.0 && std::min((then - braking.stop).norm(), p.norm()) < reach;
  });
  const bool moves = std::abs(now.v) > kStopFrom;
  const bool begins = danger && moves && left_ <= 0.0;
  if (danger && (moves || left_ > 0.0)) left_ = std::max(left_, braking.duration + kStopPause);
  left_ -= config_.period;
  return {left_ > 0.0, begins};
}

}  // namespace castaway::sim
