/// Where the lidars of a bag sit.
#pragma once

#include <map>
#include <set>
#include <string>

#include "tools/ros/tf_tree.hpp"
#include "tools/run/frame.hpp"

namespace castaway::testbed {

/// Mounts from the transforms of a bag. The tree has the say; where a channel tells the same mount
/// at full length, that one is taken.
class BagMounts {
 public:
  TfTree& tree() { return tree_; }
  /// The mount that a scan's channel tells.
  void tell(const std::string& lidar, const Eigen::Isometry3d& T_base_laser);
  /// The frame that lidars are mounted on; the first one told stays.
  void set_base_frame(const std::string& frame);
  [[nodiscard]] const std::string& base_frame() const { return base_frame_; }

  /// Mounts the scan of a lidar whose frame is known; false where it is not connected to base.
  bool mount(LaserScan& scan, const std::string& lidar_frame) const;

 private:
  TfTree tree_;
  std::string base_frame_;
  std::map<std::string, Eigen::Isometry3d> told_;  ///< By lidar.
};

}  // namespace castaway::testbed
