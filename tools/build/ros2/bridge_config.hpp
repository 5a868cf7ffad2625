/// Settings of a bridge: a run that others may look on.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "castaway/localizer.hpp"
#include "localization/geometry/pose_statistics.hpp"
#include "tools/outputs/sinks/run_messages.hpp"

namespace castaway::testbed {

/// What the user chooses.
struct BridgeOptions {
  int domain = 0;                      ///< ROS_DOMAIN_ID.
  std::string interface = "loopback";  ///< "loopback", "any" or a name.
  std::string name_space;              ///< Of all topics but /clock.
  double pace = 1.0;                   ///< Times real time; 0: as fast as it goes.
};

/// The same with what the run knows.
struct BridgeConfig {
  BridgeOptions options;
  /// Sensors, frames, map and time are published by a localizer of the run that is a node, there.
  bool without_robot = false;
  MessagesConfig messages;
  std::string description;  ///< URDF; empty: not known.
  std::optional<localization::PoseWithCovariance> start;
  std::function<void(const std::string&)> warn;  ///< Takes one sentence.
};

}  // namespace castaway::testbed
