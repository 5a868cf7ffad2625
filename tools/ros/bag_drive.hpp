/// What drives a robot, as messages.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tools/ros/ros_sensor.hpp"
#include "tools/run/frame.hpp"

namespace castaway::testbed {

/// A robot's command and its wheels at a moment.
struct DriveNow {
  double v = 0.0;                                      ///< [m/s] Commanded, forward.
  double w = 0.0;                                      ///< [rad/s] Commanded, counter-clockwise.
  std::vector<std::pair<std::string, double>> joints;  ///< Names and angles of the wheels. [rad]
};

/// The command, in the frame of base.
ros::TwistStamped command_message(Stamp stamp, const DriveNow& now);

/// Angles of the wheels; velocities from those of `dt_s` [s] before, 0 without any.
ros::JointState joints_message(Stamp stamp, const DriveNow& now,
                               const std::optional<DriveNow>& before, double dt_s);

}  // namespace castaway::testbed
