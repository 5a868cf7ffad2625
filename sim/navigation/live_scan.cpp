#include "sim/navigation/live_scan.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "sim/common/seconds.hpp"

namespace castaway::sim {
namespace {

constexpr auto kRemembered = std::chrono::seconds(1);
constexpr auto kTwistOver = std::chrono::milliseconds(50);
constexpr double kFloorHits = 0.03;  // [m] End points below this height hit the floor.

}  // namespace

void LiveScan::on_odometry(const OdometryReading& reading) {
  recent_.push_back(reading);
  while (recent_.front().stamp + kRemembered < reading.stamp) recent_.pop_front();
}

/// Pose of the last odometry reading up to `stamp`; of the first one if all readings are later.
Pose2 LiveScan::odometry_at(std::chrono::nanoseconds stamp) const {
  if (recent_.empty()) return {};
  const auto after = std::upper_bound(
      recent_.begin(), recent_.end(), stamp,
      [](std::chrono::nanoseconds t, const OdometryReading& reading) { return t < reading.stamp; });
  return (after == recent_.begin() ? after : std::prev(after))->T_odom_base;
}

void LiveScan::on_scan(const LidarReading& scan, const LidarConfig& lidar) {
  if (p_odom_.size() <= scan.lidar) p_odom_.resize(scan.lidar + 1);
  std::vector<SeenPoint>& points = p_odom_[scan.lidar];
  points.clear();
  const std::size_t columns = scan.ranges.size() / static_cast<std::size_t>(scan.layers);
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const double range = scan.ranges[i];
    if (!std::isfinite(range)) continue;
    const Eigen::Vector3d p_base = beam_point(lidar, i, range);
    if (p_base.z() <= kFloorHits) continue;
    const auto stamp = scan.stamp + scan.time_increment * static_cast<std::int64_t>(i % columns);
    points.push_back({odometry_at(stamp) * Eigen::Vector2d(p_base.head<2>()), stamp});
  }
  new_scans_.insert(scan.lidar);
}

std::vector<Eigen::Vector2d> LiveScan::p_base() const {
  const Pose2 T_base_odom = inverse(T_odom_base());
  std::vector<Eigen::Vector2d> points;
  for (const auto& p_odom : p_odom_) {
    for (const SeenPoint& point : p_odom) points.emplace_back(T_base_odom * point.p);
  }
  return points;
}

std::vector<std::vector<SeenPoint>> LiveScan::take_new_scans() {
  std::vector<std::vector<SeenPoint>> scans;
  for (const std::size_t lidar : std::exchange(new_scans_, {})) scans.push_back(p_odom_[lidar]);
  return scans;
}

Twist2 LiveScan::twist() const {
  if (recent_.empty()) return {};
  const OdometryReading& now = recent_.back();
  const auto before = std::find_if(recent_.rbegin(), recent_.rend(), [&](const auto& reading) {
    return reading.stamp + kTwistOver <= now.stamp;
  });
  if (before == recent_.rend()) return {};
  const Pose2 way = inverse(before->T_odom_base) * now.T_odom_base;
  const double dt = to_seconds(now.stamp - before->stamp);
  return {way.x / dt, way.yaw / dt};
}

std::chrono::nanoseconds LiveScan::stamp() const {
  return recent_.empty() ? std::chrono::nanoseconds{} : recent_.back().stamp;
}

Pose2 LiveScan::T_odom_base() const {
  return recent_.empty() ? Pose2{} : recent_.back().T_odom_base;
}

}  // namespace castaway::sim
