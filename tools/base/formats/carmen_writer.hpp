/// Writes the lines of CARMEN logs that `carmen_log.hpp` reads, with numbers at full precision.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "localization/geometry/se2.hpp"

namespace castaway::testbed {

/// A scan as in a CARMEN log: planar, all beams at the same time.
struct CarmenScan {
  int lidar = 1;                 ///< ROBOTLASER<n>, starting at 1.
  double angle_min = 0.0;        ///< [rad] About the laser's x, counter-clockwise.
  double angle_increment = 0.0;  ///< [rad]
  double range_max = 0.0;        ///< [m]
  std::vector<float> ranges;     ///< [m] REP-117.
  localization::SE2 T_odom_laser;
  localization::SE2 T_odom_base;
  double speed = 0.0;      ///< [m/s]
  double turn_rate = 0.0;  ///< [rad/s]
};

/// `PARAM name value host t`
std::string carmen_param_line(const std::string& name, double value);
/// `ODOM x y theta tv rv accel t host t`
std::string carmen_odometry_line(std::chrono::nanoseconds stamp,
                                 const localization::SE2& T_odom_base, double speed,
                                 double turn_rate);
/// `ROBOTLASER1 ...`: misses become the maximum range, invalid and too short ranges 0.
std::string carmen_scan_line(std::chrono::nanoseconds stamp, const CarmenScan& scan);
/// `TRUEPOS true_x true_y true_theta odom_x odom_y odom_theta t host t`
std::string carmen_truth_line(std::chrono::nanoseconds stamp, const localization::SE2& T_map_base,
                              const localization::SE2& T_odom_base);

}  // namespace castaway::testbed
