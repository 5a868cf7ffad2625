/// The drive of a robot as ROS messages.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tools/ros/ros_sensor.hpp"
#include "tools/run/frame.hpp"

namespace castaway::testbed {

/// Command and wheel angles of a robot at one moment.
struct DriveNow {
  double v = 0.0;                                      ///< [m/s] Commanded forward speed.
  double w = 0.0;                                      ///< [rad/s] Commanded turn rate,
                                                       ///< counter-clockwise.
  std::vector<std::pair<std::string, double>> joints;  ///< [rad] Names and angles of the wheel
                                                       ///< joints.
};

/// The command, in the base frame.
ros::TwistStamped command_message(Stamp stamp, const DriveNow& now);

/// Angles of the wheels, with velocities from the angles `dt_s` [s] earlier; 0 if there are none.
ros::JointState joints_message(Stamp stamp, const DriveNow& now,
                               const std::optional<DriveNow>& before, double dt_s);

}  // namespace castaway::testbed
