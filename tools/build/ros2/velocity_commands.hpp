/// Commands of a node that drives the robot.
#pragma once

#include <string>

#include "tools/build/ros2/ros_topic.hpp"
#include "tools/ros/ros_geometry.hpp"
#include "tools/run/frame.hpp"

namespace castaway::testbed {

/// Takes geometry_msgs/Twist and TwistStamped, of which Nav2 sends one, by its version.
class VelocityCommands {
 public:
  VelocityCommands(DdsParticipant& participant, const std::string& topic, double timeout_s);

  /// Takes what came until `now`, simulated time.
  void hear(Stamp now);
  /// The newest command; standstill if there was none for long.
  [[nodiscard]] BaseVelocity at(Stamp now) const;
  [[nodiscard]] int malformed() const { return plain_.malformed() + stamped_.malformed() + bad_; }

 private:
  void take(const ros::Twist& twist, Stamp now);

  Stamp timeout_;
  RosSubscription<ros::Twist> plain_;
  RosSubscription<ros::TwistStamped> stamped_;
  BaseVelocity newest_;
  Stamp came_{-1};
  int bad_ = 0;  ///< Those that hold no numbers.
};

}  // namespace castaway::testbed
