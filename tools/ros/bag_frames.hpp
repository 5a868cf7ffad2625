/// The fixed frames of a robot as /tf_static tells them.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "tools/ros/ros_geometry.hpp"
#include "tools/run/frame.hpp"

namespace castaway::testbed {

/// Frame of base: on the floor below the robot's root link.
inline constexpr const char* kBaseFrame = "base_footprint";

/// A lidar and where it sits.
struct BagLidar {
  std::string name;
  std::string frame;
  Eigen::Isometry3d T_base_laser = Eigen::Isometry3d::Identity();
};

/// base_footprint -> base_link (where there is such a link) -> all other frames. A lidar's frame is
/// where the localizers are told that it is; two lidars never share one.
class BagFrames {
 public:
  /// `links`: T_base_link of each.
  BagFrames(std::map<std::string, Eigen::Isometry3d> links, const std::vector<BagLidar>& lidars);

  /// The frame of a lidar's scans.
  [[nodiscard]] std::string frame_of(const std::string& lidar) const;
  /// Moves a lidar's frame to a mount. True if it was elsewhere, or unknown.
  bool set_mount(const std::string& lidar, const Eigen::Isometry3d& T_base_laser);
  /// All edges.
  [[nodiscard]] ros::TFMessage message(Stamp stamp) const;

 private:
  std::map<std::string, Eigen::Isometry3d> T_base_frame_;
  std::map<std::string, std::string> frame_of_lidar_;
};

}  // namespace castaway::testbed
