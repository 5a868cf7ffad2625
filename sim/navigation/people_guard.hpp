/// Keeps a robot that knows where people are from running into them.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "sim/common/geometry.hpp"

namespace castaway::sim {

/// How near is too near.
struct GuardConfig {
  double radius = 0.25;       ///< [m] Of the robot, about base.
  double margin = 0.1;        ///< [m] Kept free ahead of it.
  double deceleration = 0.3;  ///< [m/s^2] With which it brakes.
};

/// Slows down before people ahead, stops, and waits for them to go. Turns on the spot are free: the
/// robot is a disc.
class PeopleGuard {
 public:
  /// `person_radius` [m]: kept free around each.
  PeopleGuard(const GuardConfig& config, double person_radius);

  /// The velocity to drive with instead of `command`; `p_base`: people, in base. One call a control
  /// period.
  Twist2 guarded(const Twist2& command, const std::vector<Eigen::Vector2d>& p_base);
  /// True once the robot has waited for `calls` calls in a row; then it counts anew.
  bool waited(int calls);

 private:
  GuardConfig config_;
  double reach_;  ///< [m] Between two middles that touch.
  int waiting_ = 0;
};

}  // namespace castaway::sim
