#include "tools/base/formats/tum.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>

#include "tools/base/files/file.hpp"

namespace castaway::testbed {
namespace {

/// Formats a number; negative zero loses its sign.
std::string decimal(double value) {
  const std::string text = fmt::format("{:.9f}", value);
  return text == "-0.000000000" ? "0.000000000" : text;
}

/// Parses the eight numbers of a line, between blanks; false on anything else.
bool parse(std::string_view line, std::array<double, 8>& numbers) {
  constexpr double kLargest = 1e10;
  const char* at = line.data();
  const char* const end = at + line.size();
  const auto skip_blanks = [&] {
    while (at != end && (*at == ' ' || *at == '\t' || *at == '\r')) ++at;
  };
  for (double& number : numbers) {
    skip_blanks();
    const auto [next, error] = std::from_chars(at, end, number);
    if (error != std::errc{} || !(std::abs(number) <= kLargest)) return false;
    at = next;
  }
  skip_blanks();
  return at == end;
}

/// The pose of eight numbers; its yaw is that of the quaternion.
StampedPose to_pose(const std::array<double, 8>& n) {
  const double yaw = std::atan2(2.0 * (n[7] * n[6] + n[4] * n[5]),
                                n[7] * n[7] + n[4] * n[4] - n[5] * n[5] - n[6] * n[6]);
  return {std::chrono::nanoseconds(std::llround(n[0] * 1e9)), {n[1], n[2], yaw}};
}

}  // namespace

std::vector<StampedPose> read_tum(const std::filesystem::path& path) {
  std::istringstream stream(read_file(path));
  std::vector<StampedPose> poses;
  int line_number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++line_number;
    if (line.find_first_not_of(" \t\r") == std::string::npos || line.front() == '#') continue;
    const auto fail = [&](const char* what) {
      throw std::runtime_error(fmt::format("{}:{}: {}", path.string(), line_number, what));
    };
    std::array<double, 8> numbers{};
    if (!parse(line, numbers)) fail("no pose; write 'time x y z qx qy qz qw'");
    const StampedPose pose = to_pose(numbers);
    if (!poses.empty() && pose.stamp <= poses.back().stamp) fail("its time is not after the last");
    poses.push_back(pose);
  }
  if (poses.empty()) throw std::runtime_error(path.string() + ": holds no poses");
  return poses;
}

std::string tum_line(std::chrono::nanoseconds stamp, const Eigen::Isometry3d& T_map_base) {
  const std::int64_t nanoseconds = stamp.count();
  const Eigen::Vector3d p = T_map_base.translation();
  Eigen::Quaterniond q(T_map_base.linear());
  if (q.w() < 0.0) q.coeffs() *= -1.0;
  return fmt::format("{}.{:09d} {} {} {} {} {} {} {}\n", nanoseconds / 1'000'000'000,
                     nanoseconds % 1'000'000'000, decimal(p.x()), decimal(p.y()), decimal(p.z()),
                     decimal(q.x()), decimal(q.y()), decimal(q.z()), decimal(q.w()));
}

std::string tum_line(const StampedPose& pose) {
  const std::int64_t nanoseconds = pose.stamp.count();
  const double half = 0.5 * localization::wrap_angle(pose.T_map_base.yaw);
  return fmt::format("{}.{:09d} {} {} {} {} {} {} {}\n", nanoseconds / 1'000'000'000,
                     nanoseconds % 1'000'000'000, decimal(pose.T_map_base.x),
                     decimal(pose.T_map_base.y), decimal(0.0), decimal(0.0), decimal(0.0),
                     decimal(std::sin(half)), decimal(std::cos(half)));
}

}  // namespace castaway::testbed
