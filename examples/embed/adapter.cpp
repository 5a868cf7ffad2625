#include "adapter.hpp"

#include <limits>
#include <numbers>

using castaway::from_seconds;
using castaway::LaserScan;
using castaway::Odometry;

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

}  // namespace

Odometry to_odometry(const WheelMessage& message) {
  return {from_seconds(message.time_s),
          {message.forward_m, message.left_m, message.heading_deg * kDegree}};
}

LaserScan to_scan(const SweepMessage& message) {
  LaserScan scan;
  scan.stamp = from_seconds(message.time_s);
  scan.angle_min = -std::numbers::pi;
  scan.angle_increment = kDegree;
  scan.range_min = 0.05;
  scan.range_max = kLidarRange;
  for (const int distance_mm : message.distances_mm) {
    scan.ranges.push_back(distance_mm > 0 ? static_cast<float>(distance_mm) / 1000.0F
                                          : std::numeric_limits<float>::infinity());
  }
  scan.T_base_laser.translation().x() = kLidarAhead;
  return scan;
}
