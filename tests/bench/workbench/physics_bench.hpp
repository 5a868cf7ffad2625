/// Compares simulated drives with closed-form mechanics.
#pragma once

#include <string>
#include <vector>

#include "sim/robot/urdf/robot_model.hpp"

namespace castaway::testbed {

/// A quantity with a closed form, and the simulator's value for it.
struct PhysicsCheck {
  std::string what;
  std::string unit;
  double expected = 0.0;
  double measured = 0.0;
};

/// Drives the robot by physics at `physics_hz` [Hz] on a level floor and on a slope, at up to 0.5
/// m/s and 1 rad/s with 0.5 m/s^2 and 2 rad/s^2.
std::vector<PhysicsCheck> check_physics(const sim::RobotModel& robot, double physics_hz);

}  // namespace castaway::testbed
