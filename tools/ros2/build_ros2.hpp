/// Localizers that are nodes of ROS 2, where the build has them.
#pragma once

#include "tools/foreign/protocol/message_text.hpp"
#include "tools/foreign/ros2_config.hpp"
#include "tools/run/loop.hpp"

namespace castaway::testbed {

/// Takes part in the domain. Throws std::runtime_error if it cannot, or if castaway was built
/// without CycloneDDS.
NamedLocalizer build_ros2(const Ros2Config& config, const Greeting& greeting);

}  // namespace castaway::testbed
