#include "tools/commands/arguments/ros2_arguments.hpp"

namespace castaway::testbed {

void add_ros2_options(Command& command, Ros2Arguments& arguments) {
  command.add_flag("--ros2", arguments.on,
                   "Publish the run as a robot of ROS 2 does: docs/ros2.md");
  command.add_option("--ros2-domain", arguments.options.domain, "ROS_DOMAIN_ID")
      .range(0, 232)
      .show_default();
  command
      .add_option("--ros2-interface", arguments.options.interface,
                  "loopback, any, or a network interface such as eth0")
      .show_default();
  command.add_option("--ros2-namespace", arguments.options.name_space,
                     "Namespace of all topics but /clock");
}

void add_ros2_pace(Command& command, Ros2Arguments& arguments) {
  command
      .add_option("--ros2-pace", arguments.options.pace, "Times real time; 0: as fast as it goes")
      .range(0.0, 1e4)
      .show_default();
}

}  // namespace castaway::testbed
