#include "tools/ros/bag_drive.hpp"

#include "tools/ros/bag_frames.hpp"
#include "tools/ros/ros_conversion.hpp"

namespace castaway::testbed {

ros::TwistStamped command_message(Stamp stamp, const DriveNow& now) {
  ros::TwistStamped message;
  message.header = ros_header(stamp, kBaseFrame);
  message.twist.linear.x = now.v;
  message.twist.angular.z = now.w;
  return message;
}

ros::JointState joints_message(Stamp stamp, const DriveNow& now,
                               const std::optional<DriveNow>& before, double dt_s) {
  ros::JointState message;
  message.header = ros_header(stamp, "");
  for (std::size_t i = 0; i < now.joints.size(); ++i) {
    const auto& [name, angle] = now.joints[i];
    const bool moved = before && dt_s > 0.0;
    message.name.push_back(name);
    message.position.push_back(angle);
    message.velocity.push_back(moved ? (angle - before->joints[i].second) / dt_s : 0.0);
  }
  return message;
}

}  // namespace castaway::testbed
