#include "tools/formats/tum.hpp"

#include <cmath>

#include <fmt/format.h>

namespace castaway::testbed {
namespace {

/// Formats a number; negative zero loses its sign.
std::string decimal(double value) {
  const std::string text = fmt::format("{:.9f}", value);
  return text == "-0.000000000" ? "0.000000000" : text;
}

}  // namespace

std::string tum_line(const StampedPose& pose) {
  const std::int64_t nanoseconds = pose.stamp.count();
  const double half = 0.5 * localization::wrap_angle(pose.T_map_base.yaw);
  return fmt::format("{}.{:09d} {} {} {} {} {} {} {}\n", nanoseconds / 1'000'000'000,
                     nanoseconds % 1'000'000'000, decimal(pose.T_map_base.x),
                     decimal(pose.T_map_base.y), decimal(0.0), decimal(0.0), decimal(0.0),
                     decimal(std::sin(half)), decimal(std::cos(half)));
}

}  // namespace castaway::testbed
