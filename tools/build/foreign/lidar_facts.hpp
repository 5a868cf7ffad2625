/// The geometry of a lidar, which a foreign localizer is told before its first scan.
#pragma once

#include <string>
#include <vector>

#include "tools/ros/bag_frames.hpp"
#include "tools/run/frame.hpp"

namespace castaway::testbed {

/// What a lidar's scans have in common.
struct LidarFacts {
  std::string name;  ///< As in its scans; empty if there is one lidar.
  Eigen::Isometry3d T_base_laser = Eigen::Isometry3d::Identity();
  double angle_min = 0.0;        ///< [rad]
  double angle_increment = 0.0;  ///< [rad]
  double range_min = 0.0;        ///< [m]
  double range_max = 0.0;        ///< [m]
  std::size_t beams = 0;
  std::string frame = {};   ///< Of the robot's description; empty: not known.
  bool has_layers = false;  ///< It is a 3-D lidar. Programs are not told.
};

/// The facts of the lidar that took `scan`.
LidarFacts lidar_facts(const LaserScan& scan);

/// Their names, frames and mounts.
std::vector<BagLidar> bag_lidars(const std::vector<LidarFacts>& lidars);

/// True if `scan` is one of this lidar.
bool fits(const LidarFacts& facts, const LaserScan& scan);

/// The facts of every lidar in the frames, by its first scan.
std::vector<LidarFacts> lidars_of(const std::vector<Frame>& frames);

}  // namespace castaway::testbed
