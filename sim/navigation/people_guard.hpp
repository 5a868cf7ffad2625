/// Stops a robot before it runs into people, whose positions are given.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "sim/common/geometry.hpp"

namespace castaway::sim {

/// Parameters of the guard.
struct GuardConfig {
  double radius = 0.25;       ///< [m] Of the robot, about base.
  double margin = 0.1;        ///< [m] Kept free ahead of the robot.
  double deceleration = 0.3;  ///< [m/s^2] Of braking.
};

/// Slows down before people ahead, stops, and waits until they have gone. Turns in place are not
/// limited: the robot is a disc.
class PeopleGuard {
 public:
  /// `person_radius` [m]: of the disc kept free around each person.
  PeopleGuard(const GuardConfig& config, double person_radius);

  /// Returns the velocity to drive with instead of `command`. `p_base`: positions of people, in
  /// base. Called once a control period.
  Twist2 limit(const Twist2& command, const std::vector<Eigen::Vector2d>& p_base);
  /// True once the robot has waited for `calls` calls in a row; the count then starts again.
  bool has_waited(int calls);

 private:
  GuardConfig config_;
  double reach_;  ///< [m] Distance between centres at contact.
  int waiting_ = 0;
};

}  // namespace castaway::sim
