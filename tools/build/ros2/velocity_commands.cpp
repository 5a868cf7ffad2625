#include "tools/build/ros2/velocity_commands.hpp"

#include <cmath>

#include "localization/geometry/stamp.hpp"
#include "tools/build/ros2/ros_qos.hpp"

namespace castaway::testbed {

VelocityCommands::VelocityCommands(DdsParticipant& participant, const std::string& topic,
                                   double timeout_s)
    : timeout_(localization::from_seconds(timeout_s)),
      plain_(participant, topic, ros_qos::kUsual),
      stamped_(participant, topic, ros_qos::kUsual) {}

void VelocityCommands::take(const ros::Twist& twist, Stamp now) {
  if (!std::isfinite(twist.linear.x) || !std::isfinite(twist.angular.z)) {
    ++bad_;
    return;
  }
  newest_ = {twist.linear.x, twist.angular.z};
  came_ = now;
}

void VelocityCommands::hear(Stamp now) {
  while (const auto message = plain_.take()) take(*message, now);
  while (const auto message = stamped_.take()) take(message->twist, now);
}

BaseVelocity VelocityCommands::at(Stamp now) const {
  return came_ >= Stamp{} && now - came_ <= timeout_ ? newest_ : BaseVelocity{};
}

}  // namespace castaway::testbed
