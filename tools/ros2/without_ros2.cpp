// In place of build_ros2.cpp where there is no CycloneDDS.
#include <stdexcept>

#include "tools/ros2/build_ros2.hpp"

namespace castaway::testbed {

NamedLocalizer build_ros2(const Ros2Config&, const Greeting&) {
  throw std::runtime_error(
      "this castaway was built without ROS 2: install cyclonedds-dev and build it again");
}

}  // namespace castaway::testbed
