/// Physics against closed forms: what a drive does and what it should.
#pragma once

#include <string>
#include <vector>

#include "sim/robot/urdf/robot_model.hpp"

namespace castaway::testbed {

/// A figure that mechanics gives in one line, and what the simulator makes of it.
struct PhysicsCheck {
  std::string what;
  std::string unit;
  double expected = 0.0;
  double measured = 0.0;
};

/// Drives the robot by physics at `physics_hz` on an open floor and on a slope, at up to 0.5 m/s
/// and 1 rad/s with 0.5 m/s^2 and 2 rad/s^2.
std::vector<PhysicsCheck> check_physics(const sim::RobotModel& robot, double physics_hz);

}  // namespace castaway::testbed
