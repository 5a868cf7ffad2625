#include "tools/formats/tum.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>

#include "tools/files/file.hpp"

namespace castaway::testbed {
namespace {

constexpr double kLargest = 8e9;  // [s], [m] In nanoseconds it fits 64 bits.

/// A number without the sign of a zero.
std::string decimal(double value) {
  const std::string text = fmt::format("{:.9f}", value);
  return text == "-0.000000000" ? "0.000000000" : text;
}

StampedPose parse_line(std::string_view line, const std::string& place) {
  std::array<double, 8> columns{};
  for (double& column : columns) {
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), column);
    if (error != std::errc{} || !(std::abs(column) <= kLargest)) {
      throw std::runtime_error(place + ": needs 8 numbers: timestamp tx ty tz qx qy qz qw");
    }
    line.remove_prefix(static_cast<std::size_t>(end - line.data()));
  }
  const double qx = columns[4];
  const double qy = columns[5];
  const double qz = columns[6];
  const double qw = columns[7];
  const double yaw = std::atan2(2.0 * (qw * qz + qx * qy), 1.0 - 2.0 * (qy * qy + qz * qz));
  return {std::chrono::nanoseconds(std::llround(columns[0] * 1e9)), {columns[1], columns[2], yaw}};
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

std::vector<StampedPose> read_tum(const std::filesystem::path& path) {
  const std::string text = read_file(path);
  std::vector<StampedPose> poses;
  int line_number = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line(text.data() + begin, end - begin);
    ++line_number;
    if (line.find_first_not_of(" \t\r") != std::string_view::npos && line[0] != '#') {
      poses.push_back(parse_line(line, fmt::format("{}:{}", path.string(), line_number)));
    }
    begin = end + 1;
  }
  return poses;
}

}  // namespace castaway::testbed
