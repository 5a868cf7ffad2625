// In place of build_ros2.cpp where there is no CycloneDDS.
#include <stdexcept>

#include "tools/build/ros2/build_ros2.hpp"

namespace castaway::testbed {
namespace {

[[noreturn]] void refuse() {
  throw std::runtime_error(
      "this castaway was built without ROS 2: install cyclonedds-dev and build it again");
}

}  // namespace

NamedLocalizer build_ros2(const Ros2Config&, const Greeting&) { refuse(); }

std::unique_ptr<RunSink> build_bridge(const RunInfo&, const RosMap&, BridgeConfig) { refuse(); }

std::shared_ptr<TopicWriter> build_wire(const BridgeConfig&) { refuse(); }

}  // namespace castaway::testbed
