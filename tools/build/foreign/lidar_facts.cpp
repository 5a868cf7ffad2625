#include "tools/build/foreign/lidar_facts.hpp"

#include <algorithm>

namespace castaway::testbed {

LidarFacts lidar_facts(const LaserScan& scan) {
  return {scan.lidar,          scan.T_base_laser, scan.angle_min,     scan.angle_increment,
          scan.range_min,      scan.range_max,    scan.ranges.size(), {},
          !scan.layers.empty()};
}

bool fits(const LidarFacts& facts, const LaserScan& scan) {
  return facts.name == scan.lidar && facts.angle_min == scan.angle_min &&
         facts.angle_increment == scan.angle_increment && facts.range_min == scan.range_min &&
         facts.range_max == scan.range_max && facts.beams == scan.ranges.size() &&
         facts.T_base_laser.matrix() == scan.T_base_laser.matrix();
}

std::vector<LidarFacts> lidars_of(const std::vector<Frame>& frames) {
  std::vector<LidarFacts> lidars;
  for (const Frame& frame : frames) {
    const auto* taken = std::get_if<ScanFrame>(&frame.data);
    if (taken == nullptr) continue;
    const bool is_known = std::any_of(lidars.begin(), lidars.end(), [&](const LidarFacts& lidar) {
      return lidar.name == taken->scan.lidar;
    });
    if (!is_known) lidars.push_back(lidar_facts(taken->scan));
  }
  return lidars;
}

std::vector<BagLidar> bag_lidars(const std::vector<LidarFacts>& lidars) {
  std::vector<BagLidar> mounts;
  for (const LidarFacts& lidar : lidars) {
    mounts.push_back({lidar.name, lidar.frame, lidar.T_base_laser});
  }
  return mounts;
}

}  // namespace castaway::testbed
