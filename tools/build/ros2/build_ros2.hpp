/// What castaway is on the wire of ROS 2, where the build has it.
#pragma once

#include <memory>

#include "tools/build/foreign/message_text.hpp"
#include "tools/build/ros2/bridge_config.hpp"
#include "tools/run/loop.hpp"
#include "tools/run/ros2_config.hpp"

namespace castaway::testbed {

/// Takes part in the domain. Throws std::runtime_error if it cannot, or if castaway was built
/// without CycloneDDS.
NamedLocalizer build_ros2(const Ros2Config& config, const Greeting& greeting);

/// Takes part in the domain and publishes the run there. Throws as `build_ros2`.
std::unique_ptr<RunSink> build_bridge(const RunInfo& info, const RosMap& map, BridgeConfig config);

/// Takes part in the domain: what is written is published there. Throws as `build_ros2`.
std::shared_ptr<TopicWriter> build_wire(const BridgeConfig& config);

}  // namespace castaway::testbed
