/// Lets nodes of ROS 2 look on at a run.
#pragma once

#include <vector>

#include "tools/build/ros2/bridge_config.hpp"
#include "tools/scenario/sections/scenario.hpp"

namespace castaway::testbed {

/// The bridge of a run with these localizers, of which one that is a node may publish the robot
/// already. Warnings are printed.
BridgeConfig bridge_config(const BridgeOptions& options,
                           const std::vector<LocalizerSpec>& localizers);

}  // namespace castaway::testbed
