#include "tools/ros/ros_conversion.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <sstream>
#include <stdexcept>

#include <fmt/format.h>

#include "localization/geometry/exact_atan2.hpp"

namespace castaway::testbed {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;
constexpr double kLongestRosSweep = 10.0;  // [s] Longer sweeps are driver errors and ignored.
constexpr double kFastest = 20.0;          // [m/s] Faster motion is a kidnap.

std::optional<double> number_in(const std::map<std::string, std::string>& texts,
                                const std::string& key) {
  const auto found = texts.find(key);
  if (found == texts.end()) return std::nullopt;
  double value = 0.0;
  const char* end = found->second.data() + found->second.size();
  const auto result = std::from_chars(found->second.data(), end, value);
  return result.ec == std::errc{} && result.ptr == end ? std::optional(value) : std::nullopt;
}

/// The exact number of a rounded one, if it is known and consistent.
double exact_number(float rounded, const std::map<std::string, std::string>& exact,
                    const std::string& key) {
  const auto value = number_in(exact, key);
  return value && static_cast<float>(*value) == rounded ? *value : static_cast<double>(rounded);
}

constexpr float kLongestRange = 1e6F;   // [m] Some drivers state the largest float.
constexpr double kFarthestPoint = 1e7;  // [m] UTM coordinates are smaller.

void require_numbers(std::initializer_list<double> values, const char* what) {
  for (const double value : values) {
    if (std::abs(value) <= kFarthestPoint) continue;
    throw std::runtime_error(std::isfinite(value)
                                 ? fmt::format("a {} holds {}, more than {} (metres, radians)",
                                               what, value, kFarthestPoint)
                                 : fmt::format("a {} holds no numbers", what));
  }
}

double yaw_of(const ros::Quaternion& q) {
  if (q.x == 0.0 && q.y == 0.0) {
    const double yaw = 2.0 * localization::exact_atan2(q.z, q.w);
    return std::abs(yaw) <= std::numbers::pi ? yaw : localization::wrap_angle(yaw);
  }
  return std::atan2(2.0 * (q.w * q.z + q.x * q.y), 1.0 - 2.0 * (q.y * q.y + q.z * q.z));
}

/// The double that is this many representable values away.
double offset_by_ulps(double value, int steps) {
  for (; steps > 0; --steps) value = std::nextafter(value, 2.0);
  for (; steps < 0; ++steps) value = std::nextafter(value, -2.0);
  return value;
}

/// The quaternion near a yaw that `yaw_of` converts back exactly; the nearest one if there is none.
ros::Quaternion planar_quaternion(double yaw) {
  const ros::Quaternion nearest{0.0, 0.0, std::sin(0.5 * yaw), std::cos(0.5 * yaw)};
  constexpr std::array<int, 7> kSteps{0, 1, -1, 2, -2, 3, -3};
  for (const int z : kSteps) {
    for (const int w : kSteps) {
      const ros::Quaternion q{0.0, 0.0, offset_by_ulps(nearest.z, z), offset_by_ulps(nearest.w, w)};
      if (yaw_of(q) == yaw) return q;
    }
  }
  return nearest;
}

}  // namespace

ros::Time to_ros_time(Stamp stamp) {
  const std::int64_t ns = std::max<std::int64_t>((stamp + kBagEpoch).count(), 0);
  return {static_cast<std::int32_t>(ns / kSecond), static_cast<std::uint32_t>(ns % kSecond)};
}

Stamp from_ros_time(const ros::Time& time) { return Stamp(time.sec * kSecond + time.nanosec); }

ros::Header ros_header(Stamp stamp, const std::string& frame) {
  return {to_ros_time(stamp), frame};
}

ros::Pose to_ros_pose(const SE2& pose) {
  const bool in_range = std::abs(pose.yaw) <= std::numbers::pi;
  const double yaw = in_range ? pose.yaw : localization::wrap_angle(pose.yaw);
  return {{pose.x, pose.y, 0.0}, planar_quaternion(yaw)};
}

ros::Pose to_ros_pose(const Eigen::Isometry3d& T_parent_child) {
  const auto& [p, q] = to_ros_transform(T_parent_child);
  return {{p.x, p.y, p.z}, q};
}

SE2 from_ros_pose(const ros::Pose& pose) {
  const SE2 planar{pose.position.x, pose.position.y, yaw_of(pose.orientation)};
  require_numbers({planar.x, planar.y, planar.yaw}, "pose");
  return planar;
}

ros::Transform to_ros_transform(const Eigen::Isometry3d& T_parent_child) {
  const Eigen::Vector3d p = T_parent_child.translation();
  const Eigen::Quaterniond q(T_parent_child.linear());
  return {{p.x(), p.y(), p.z()}, {q.x(), q.y(), q.z(), q.w()}};
}

Eigen::Isometry3d from_ros_transform(const ros::Transform& transform) {
  const Eigen::Vector3d p(transform.translation.x, transform.translation.y,
                          transform.translation.z);
  Eigen::Quaterniond q(transform.rotation.w, transform.rotation.x, transform.rotation.y,
                       transform.rotation.z);
  require_numbers({p.x(), p.y(), p.z(), q.norm()}, "transform");
  if (!(q.norm() > 1e-6)) throw std::runtime_error("a transform holds no rotation");
  return Eigen::Translation3d(p) * q.normalized();
}

std::array<double, 36> to_ros_covariance(const Eigen::Matrix3d& covariance) {
  constexpr std::array<std::size_t, 3> kAt{0, 1, 5};  // x, y, rotation about z.
  std::array<double, 36> all{};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      all[kAt[row] * 6 + kAt[column]] =
          covariance(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column));
    }
  }
  return all;
}

ros::Twist twist_between(const SE2& from, const SE2& to, double dt_s) {
  ros::Twist twist;
  if (!(dt_s > 0.0) || localization::distance(from, to) > kFastest * dt_s) return twist;
  const SE2 way = from.inverse() * to;
  twist.linear.x = way.x / dt_s;
  twist.linear.y = way.y / dt_s;
  twist.angular.z = localization::wrap_angle(way.yaw) / dt_s;
  return twist;
}

ros::LaserScan to_ros_scan(const LaserScan& scan, const ScanTruth& truth,
                           const std::string& frame) {
  const std::size_t last = scan.ranges.empty() ? 0 : scan.ranges.size() - 1;
  const double time_increment_s = seconds(scan.time_increment);
  ros::LaserScan message;
  message.header = ros_header(scan.stamp, frame);
  message.angle_min = static_cast<float>(scan.angle_min);
  message.angle_max = static_cast<float>(scan.beam_angle(last));
  message.angle_increment = static_cast<float>(scan.angle_increment);
  message.time_increment = static_cast<float>(time_increment_s);
  message.scan_time = static_cast<float>(time_increment_s * static_cast<double>(last + 1));
  message.range_min = static_cast<float>(scan.range_min);
  message.range_max = static_cast<float>(scan.range_max);
  message.ranges = scan.ranges;
  message.intensities = truth.intensities;
  return message;
}

std::map<std::string, std::string> exact_scan_numbers(const LaserScan& scan) {
  std::string mount;
  for (int i = 0; i < 12; ++i) {
    mount += fmt::format("{}{}", i > 0 ? " " : "", scan.T_base_laser(i / 4, i % 4));
  }
  return {{"castaway.lidar", scan.lidar},
          {"castaway.T_base_laser", mount},
          {"castaway.angle_min", fmt::format("{}", scan.angle_min)},
          {"castaway.angle_increment", fmt::format("{}", scan.angle_increment)},
          {"castaway.time_increment", fmt::format("{}", seconds(scan.time_increment))},
          {"castaway.range_min", fmt::format("{}", scan.range_min)},
          {"castaway.range_max", fmt::format("{}", scan.range_max)}};
}

std::optional<Eigen::Isometry3d> exact_mount(const std::map<std::string, std::string>& exact) {
  const auto found = exact.find("castaway.T_base_laser");
  if (found == exact.end()) return std::nullopt;
  std::istringstream stream(found->second);
  stream.imbue(std::locale::classic());
  Eigen::Isometry3d mount = Eigen::Isometry3d::Identity();
  for (int i = 0; i < 12; ++i) {
    double& value = mount(i / 4, i % 4);
    if (!(stream >> value) || !(std::abs(value) <= kFarthestPoint)) return std::nullopt;
  }
  return mount;
}

LaserScan from_ros_scan(const ros::LaserScan& message,
                        const std::map<std::string, std::string>& exact) {
  const float range_max = std::min(message.range_max, kLongestRange);
  const bool timed = std::isfinite(message.time_increment);  // An infinite value is ignored below.
  require_numbers({message.angle_min, message.angle_increment, message.range_min, range_max,
                   timed ? 0.0 : static_cast<double>(message.time_increment)},
                  "LaserScan");
  LaserScan scan;
  scan.stamp = from_ros_time(message.header.stamp);
  scan.angle_min = exact_number(message.angle_min, exact, "castaway.angle_min");
  scan.angle_increment = exact_number(message.angle_increment, exact, "castaway.angle_increment");
  const double time_increment_s =
      exact_number(message.time_increment, exact, "castaway.time_increment");
  const double sweep_s = time_increment_s * static_cast<double>(message.ranges.size());
  const bool sensible = sweep_s >= 0.0 && sweep_s <= kLongestRosSweep;
  scan.time_increment = localization::from_seconds(sensible ? time_increment_s : 0.0);
  scan.range_min = exact_number(message.range_min, exact, "castaway.range_min");
  scan.range_max = exact_number(range_max, exact, "castaway.range_max");
  scan.ranges = message.ranges;
  const auto lidar = exact.find("castaway.lidar");
  if (lidar != exact.end()) scan.lidar = lidar->second;
  return scan;
}

ros::OccupancyGrid to_ros_grid(const RosMap& map) {
  ros::OccupancyGrid message;
  message.header = ros_header({}, "map");
  message.info.map_load_time = message.header.stamp;
  message.info.resolution = static_cast<float>(map.resolution);
  message.info.width = static_cast<std::uint32_t>(map.width);
  message.info.height = static_cast<std::uint32_t>(map.height);
  message.info.origin = to_ros_pose({map.origin_x, map.origin_y, map.origin_yaw});
  message.data = map.cells;
  return message;
}

RosMap from_ros_grid(const ros::OccupancyGrid& message, const std::string& name) {
  const ros::MapMetaData& info = message.info;
  const std::uint64_t cells = std::uint64_t{info.width} * info.height;
  if (cells == 0 || cells != message.data.size() || info.width > 1'000'000 ||
      info.height > 1'000'000 || !(info.resolution >= 0.001F && info.resolution <= 10.0F)) {
    throw std::runtime_error(fmt::format("an OccupancyGrid says {} x {} cells of {} m and holds {}",
                                         info.width, info.height, info.resolution,
                                         message.data.size()));
  }
  const SE2 origin = from_ros_pose(info.origin);
  const std::string decimal = fmt::format("{}", info.resolution);
  RosMap map;
  map.name = name;
  map.width = static_cast<int>(info.width);
  map.height = static_cast<int>(info.height);
  std::from_chars(decimal.data(), decimal.data() + decimal.size(), map.resolution);
  map.origin_x = origin.x;
  map.origin_y = origin.y;
  map.origin_yaw = origin.yaw;
  map.cells = message.data;
  return map;
}

}  // namespace castaway::testbed
