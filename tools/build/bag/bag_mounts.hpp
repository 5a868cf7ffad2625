/// Mounts of the sensors of a bag.
#pragma once

#include <map>
#include <set>
#include <string>

#include "tools/ros/tf_tree.hpp"
#include "tools/run/frame.hpp"

namespace castaway::testbed {

/// Mounts from the transforms of a bag. If a channel's metadata states the same mount at full
/// precision, that one is used.
class BagMounts {
 public:
  TfTree& tree() { return tree_; }
  /// Sets the mount stated by the metadata of a scan's channel.
  void set_stated_mount(const std::string& lidar, const Eigen::Isometry3d& T_base_laser);
  /// Sets the frame that lidars are mounted on; only the first call has an effect.
  void set_base_frame(const std::string& frame);
  [[nodiscard]] const std::string& base_frame() const { return base_frame_; }

  /// The pose of a frame in base; nothing if it is not connected to base.
  [[nodiscard]] std::optional<Eigen::Isometry3d> of(const std::string& frame) const;
  /// [m] Height of base above the frame base_footprint, which is on the ground (REP-120); 0 for a
  /// base that is a footprint itself. Nothing without such a frame.
  [[nodiscard]] std::optional<double> base_height() const;

  /// Sets the mount of a scan; false if the lidar's frame is not connected to base.
  bool mount(LaserScan& scan, const std::string& lidar_frame) const;

 private:
  TfTree tree_;
  std::string base_frame_;
  std::map<std::string, Eigen::Isometry3d> stated_;  ///< Mounts from channel metadata, by lidar.
};

}  // namespace castaway::testbed
