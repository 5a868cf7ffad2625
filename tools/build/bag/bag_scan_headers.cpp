#include "tools/build/bag/bag_scan_headers.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace castaway::testbed {
namespace {

/// A lidar without any range.
struct Rangeless {
  int scans = 0;
  float longest = 0.0F;  ///< [m] Longest return of all its scans.
};

bool has_no_range(const LaserScan& scan) { return scan.range_max <= std::max(scan.range_min, 0.0); }

float longest_return(const LaserScan& scan) {
  float longest = 0.0F;
  for (const float range : scan.ranges) {
    if (std::isfinite(range)) longest = std::max(longest, range);
  }
  return longest;
}

std::map<std::string, Rangeless> rangeless_lidars(const Frames& frames) {
  std::map<std::string, Rangeless> lidars;
  for (const Frame& frame : frames) {
    const auto* scan = std::get_if<ScanFrame>(&frame.data);
    if (scan == nullptr || !has_no_range(scan->scan)) continue;
    Rangeless& lidar = lidars[scan->scan.lidar];
    ++lidar.scans;
    lidar.longest = std::max(lidar.longest, longest_return(scan->scan));
  }
  return lidars;
}

std::string who(const std::string& lidar) {
  return lidar.empty() ? "" : " of lidar '" + lidar + "'";
}

}  // namespace

LaserScan BagScanHeaders::take(const ros::LaserScan& message, LaserScan scan) {
  if (scan.angle_increment != 0.0 || scan.ranges.size() < 2) return scan;
  const double angle = static_cast<double>(message.angle_max) - message.angle_min;
  if (angle == 0.0 || !std::isfinite(angle)) {
    throw std::runtime_error(
        "a LaserScan has angle_increment 0 and angle_max = angle_min, so that the directions of "
        "its "
        "beams are unknown; correct the driver's parameters and record again");
  }
  scan.angle_increment = angle / static_cast<double>(scan.ranges.size() - 1);
  ++without_increment_[scan.lidar];
  return scan;
}

std::vector<std::string> BagScanHeaders::complete(const std::string& bag, Frames& frames) const {
  std::vector<std::string> warnings;
  for (const auto& [lidar, scans] : without_increment_) {
    warnings.push_back(fmt::format(
        "{}: angle_increment is 0 in {} scans{}; it is computed from angle_min and angle_max", bag,
        scans, who(lidar)));
  }
  const auto rangeless = rangeless_lidars(frames);
  for (Frame& frame : frames) {
    auto* scan = std::get_if<ScanFrame>(&frame.data);
    if (scan == nullptr || !has_no_range(scan->scan)) continue;
    // The longest return still is one.
    const float longest = rangeless.at(scan->scan.lidar).longest;
    scan->scan.range_max = std::nextafter(longest, 2.0F * longest + 1.0F);
  }
  for (const auto& [lidar, missing] : rangeless) {
    warnings.push_back(fmt::format(
        "{}: range_max is not above range_min in {} scans{}; the longest return, {:.2f} "
        "m, is taken for it",
        bag, missing.scans, who(lidar), missing.longest));
  }
  return warnings;
}

}  // namespace castaway::testbed
