/// The fixed frames of a robot, as in /tf_static.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "tools/ros/ros_geometry.hpp"
#include "tools/run/frame.hpp"

namespace castaway::testbed {

/// The base frame: on the floor below the robot's root link.
inline constexpr const char* kBaseFrame = "base_footprint";

/// A lidar and its mount.
struct BagLidar {
  std::string name;
  std::string frame;
  Eigen::Isometry3d T_base_laser = Eigen::Isometry3d::Identity();
};

/// Tree base_footprint -> base_link (if the robot has it) -> all other frames. A lidar's frame is
/// at its nominal mount; every lidar has its own frame.
class BagFrames {
 public:
  /// `links`: T_base_link of each link.
  BagFrames(std::map<std::string, Eigen::Isometry3d> links, const std::vector<BagLidar>& lidars,
            std::string base = kBaseFrame);

  /// Frame of a lidar's scans.
  [[nodiscard]] std::string frame_of(const std::string& lidar) const;
  /// Moves a lidar's frame to a mount. Returns true if this changes it.
  bool set_mount(const std::string& lidar, const Eigen::Isometry3d& T_base_laser);
  [[nodiscard]] ros::TFMessage message(Stamp stamp) const;

 private:
  std::string base_;
  std::map<std::string, Eigen::Isometry3d> T_base_frame_;
  std::map<std::string, std::string> frame_of_lidar_;
};

}  // namespace castaway::testbed
