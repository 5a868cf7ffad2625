/// Watches that nobody else publishes simulated time.
#pragma once

#include "tools/build/ros2/ros_topic.hpp"
#include "tools/ros/ros_wire.hpp"

namespace castaway::testbed {

/// Two times in a domain would confuse every node.
class OtherClocks {
 public:
  /// Throws std::runtime_error if there is one in the participant's domain.
  OtherClocks(DdsParticipant& participant, int domain);

  /// Drops what came.
  void drain() {
    while (clock_.take()) {
    }
  }

 private:
  RosSubscription<ros::Clock> clock_;
};

}  // namespace castaway::testbed
