/// The process that publishes a live run for nodes of ROS 2.
#pragma once

#include <memory>

#include "tools/build/ros2/bridge_config.hpp"
#include "tools/live/lines/bridge_link.hpp"

namespace castaway::testbed {

/// Starts it: the process of a run copies itself, which one with threads cannot. It ends when
/// nobody is left who holds the link. Throws std::runtime_error if it cannot take part in the
/// domain.
std::shared_ptr<BridgeLink> start_bridge(const BridgeConfig& config);

}  // namespace castaway::testbed
