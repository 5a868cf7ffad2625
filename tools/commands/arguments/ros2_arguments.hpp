/// Options of commands whose runs nodes of ROS 2 may look on.
#pragma once

#include <optional>

#include "tools/build/ros2/bridge_config.hpp"
#include "tools/commands/arguments/command_line.hpp"

namespace castaway::testbed {

/// Values from the command line.
struct Ros2Arguments {
  bool on = false;
  BridgeOptions options;

  /// Nothing: nobody looks on.
  [[nodiscard]] std::optional<BridgeOptions> bridge() const {
    return on ? std::optional(options) : std::nullopt;
  }
};

/// Adds --ros2 and where its topics are.
void add_ros2_options(Command& command, Ros2Arguments& arguments);

/// Adds --ros2-pace, for runs that nobody else sets the speed of.
void add_ros2_pace(Command& command, Ros2Arguments& arguments);

}  // namespace castaway::testbed
