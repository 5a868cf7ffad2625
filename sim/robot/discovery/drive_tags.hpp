/// Reads a robot's drive from its description's plug-in tags. Internal to sim/robot.
///
/// Four dialects: Gazebo classic with ROS 1 (`<leftJoint>`, `<wheelSeparation>`), with ROS 2
/// (`<left_joint>`, `<wheel_separation>`), gz-sim's DiffDrive (`<left_joint>`, `<wheel_radius>`),
/// and ros2_control (`<command_interface name="velocity">`, sides and sizes in the controllers'
/// YAML file) with its forerunner of ROS 1 (`<transmission>`).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/robot/urdf/urdf_file.hpp"

namespace castaway::sim {

/// A drive as its tags describe it. Everything is optional.
struct DriveTags {
  std::string dialect;               ///< "gazebo-classic", "gazebo-ros2", "gz-sim", "ros2_control"
                                     ///< or "transmission"; empty: no tag.
  std::vector<std::string> left;     ///< Joints.
  std::vector<std::string> right;    ///< Joints.
  std::vector<std::string> driven;   ///< Joints on an unknown side.
  std::optional<double> separation;  ///< [m] Between left and right wheels.
  std::optional<double> radius;      ///< [m] Of the wheels.
  /// Types of the controllers in the plug-ins' parameter files, such as
  /// "mecanum_drive_controller/MecanumDriveController".
  std::vector<std::string> controllers;
};

/// Returns the first drive that the tags of a robot describe.
DriveTags find_drive_tags(const UrdfFile& file, const PackageFinder& packages,
                          const xacro::Options& options);

}  // namespace castaway::sim
