/// Settings of a localizer that is a node of ROS 2.
#pragma once

#include <string>

namespace castaway::testbed {

/// Where estimates come from.
enum class Ros2Answer {
  kTransform,  ///< The transform from map to odom on /tf.
  kPose,       ///< Poses on /amcl_pose.
};

/// Names of topics; those that do not begin with a slash are in the namespace.
struct Ros2Topics {
  std::string scan = "scan";      ///< Of several lidars: behind the lidar's name, "front/scan".
  std::string points = "points";  ///< The same for all layers of 3-D lidars.
  std::string odom = "odom";
  std::string imu = "imu";
  std::string tf = "tf";
  std::string tf_static = "tf_static";
  std::string map = "map";
  std::string initial_pose = "initialpose";
  std::string pose = "amcl_pose";
  std::string particles = "particle_cloud";
  std::string command = "cmd_vel";
};

/// Names of frames (REP-105). Those of lidars are the robot's.
struct Ros2Frames {
  std::string map = "map";
  std::string odom = "odom";
  std::string base = "base_footprint";
};

/// A localizer that is a node of ROS 2, and how it is spoken to: docs/ros2.md.
struct Ros2Config {
  int domain = 0;                      ///< ROS_DOMAIN_ID.
  std::string interface = "loopback";  ///< "loopback", "any" or a name.
  std::string name_space;              ///< Of the topics.
  Ros2Answer answer = Ros2Answer::kTransform;
  double ahead_s = 0.0;            ///< [s] How long after its scan map->odom is stamped.
  double timeout_s = 1.0;          ///< [s] Wall time for the answer to a scan.
  double start_timeout_s = 60.0;   ///< [s] Wall time until the node answers for the first time.
  double pace = 0.0;               ///< Times real time; 0: in lock step.
  bool reliable_scans = false;     ///< Quality of service of scans and points; false: best effort.
  bool drive = false;              ///< The robot follows the node's commands.
  double command_timeout_s = 0.5;  ///< [s] Simulated time after which it stops without a new one.
  Ros2Topics topics;
  Ros2Frames frames;
};

}  // namespace castaway::testbed
