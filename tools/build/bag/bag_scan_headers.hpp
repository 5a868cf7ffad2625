/// Headers of scans that some drivers leave at 0.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "tools/build/recorded/recorded_source.hpp"
#include "tools/ros/ros_sensor.hpp"

namespace castaway::testbed {

/// Completes the scans of a bag: an `angle_increment` of 0 by `angle_max`, and a `range_max` of 0
/// by the longest return of its lidar in the whole bag.
class BagScanHeaders {
 public:
  /// Returns `scan`, which was read from `message`, with its increment. Throws std::runtime_error
  /// if the message does not tell the directions of its beams.
  LaserScan take(const ros::LaserScan& message, LaserScan scan);
  /// Sets ranges that are missing, and returns a warning for each thing that was.
  std::vector<std::string> complete(const std::string& bag, Frames& frames) const;

 private:
  std::map<std::string, int> without_increment_;  ///< Number of scans, by lidar.
};

}  // namespace castaway::testbed
