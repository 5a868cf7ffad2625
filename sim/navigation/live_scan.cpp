#include "sim/navigation/live_scan.hpp"

#include <cmath>

namespace castaway::sim {
namespace {

constexpr auto kRemembered = std::chrono::seconds(1);
constexpr double kFloor = 0.03;  // [m] Lower end points are the floor's.

}  // namespace

void LiveScan::on_odometry(const OdometryReading& reading) {
  recent_.push_back(reading);
  while (recent_.front().stamp + kRemembered < reading.stamp) recent_.pop_front();
}

/// The last reading up to then; the first one where the scan is older than all.
Pose2 LiveScan::odometry_at(std::chrono::nanoseconds stamp) const {
  if (recent_.empty()) return {};
  Pose2 pose = recent_.front().T_odom_base;
  for (const OdometryReading& reading : recent_) {
    if (reading.stamp > stamp) break;
    pose = reading.T_odom_base;
  }
  return pose;
}

void LiveScan::on_scan(const LidarReading& scan, const LidarConfig& lidar) {
  const Pose2 T_odom_base = odometry_at(scan.stamp);
  if (p_odom_.size() <= scan.lidar) p_odom_.resize(scan.lidar + 1);
  std::vector<Eigen::Vector2d>& points = p_odom_[scan.lidar];
  points.clear();
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const double range = scan.ranges[i];
    if (!std::isfinite(range)) continue;
    const Eigen::Vector3d p_base = beam_point(lidar, i, range);
    if (p_base.z() > kFloor) points.push_back(T_odom_base * Eigen::Vector2d(p_base.head<2>()));
  }
}

std::vector<Eigen::Vector2d> LiveScan::p_base() const {
  const Pose2 T_base_odom = inverse(T_odom_base());
  std::vector<Eigen::Vector2d> points;
  for (const auto& p_odom : p_odom_) {
    for (const Eigen::Vector2d& p : p_odom) points.push_back(T_base_odom * p);
  }
  return points;
}

Pose2 LiveScan::T_odom_base() const {
  return recent_.empty() ? Pose2{} : recent_.back().T_odom_base;
}

}  // namespace castaway::sim
