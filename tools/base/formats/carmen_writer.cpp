#include "tools/base/formats/carmen_writer.hpp"

#include <cmath>

#include <fmt/format.h>

namespace castaway::testbed {
namespace {

constexpr const char* kHost = "castaway";

/// The fields `t host t` and the end of the line.
std::string time_fields(std::chrono::nanoseconds stamp) {
  const double t = std::chrono::duration<double>(stamp).count();
  return fmt::format("{:.9f} {} {:.9f}\n", t, kHost, t);
}

std::string pose_fields(const localization::SE2& pose) {
  return fmt::format("{} {} {}", pose.x, pose.y, pose.yaw);
}

void append_range(std::string& line, float range, double range_max) {
  line += ' ';
  if (std::isinf(range) && range > 0.0F) {
    fmt::format_to(std::back_inserter(line), "{}", range_max);
  } else if (std::isfinite(range)) {
    fmt::format_to(std::back_inserter(line), "{}", range);
  } else {
    line += '0';
  }
}

}  // namespace

std::string carmen_param_line(const std::string& name, double value) {
  return fmt::format("PARAM {} {} {} 0\n", name, value, kHost);
}

std::string carmen_odometry_line(std::chrono::nanoseconds stamp,
                                 const localization::SE2& T_odom_base, double speed,
                                 double turn_rate) {
  return fmt::format("ODOM {} {} {} 0 {}", pose_fields(T_odom_base), speed, turn_rate,
                     time_fields(stamp));
}

std::string carmen_scan_line(std::chrono::nanoseconds stamp, const CarmenScan& scan) {
  const std::size_t beams = scan.ranges.size();
  const double fov = scan.angle_increment * static_cast<double>(beams > 0 ? beams - 1 : 0);
  std::string line = fmt::format("ROBOTLASER{} 0 {} {} {} {} 0.01 0 {}", scan.lidar, scan.angle_min,
                                 fov, scan.angle_increment, scan.range_max, beams);
  for (const float range : scan.ranges) append_range(line, range, scan.range_max);
  line += fmt::format(" 0 {} {} {} {} 0 0 0 ", pose_fields(scan.T_odom_laser),
                      pose_fields(scan.T_odom_base), scan.speed, scan.turn_rate);
  return line + time_fields(stamp);
}

std::string carmen_truth_line(std::chrono::nanoseconds stamp, const localization::SE2& T_map_base,
                              const localization::SE2& T_odom_base) {
  return fmt::format("TRUEPOS {} {} {}", pose_fields(T_map_base), pose_fields(T_odom_base),
                     time_fields(stamp));
}

}  // namespace castaway::testbed
