/// Qualities of service that ROS 2 uses.
#pragma once

#include "tools/ros/dds/dds_participant.hpp"

namespace castaway::testbed::ros_qos {

inline constexpr DdsQos kUsual{true, false, 10};
inline constexpr DdsQos kTransforms{true, false, 100};  // As of tf2_ros.
inline constexpr DdsQos kLatched{true, true, 1};        // For those that come late.
inline constexpr DdsQos kSensor{false, false, 5};
inline constexpr DdsQos kClock{false, false, 1};

}  // namespace castaway::testbed::ros_qos
