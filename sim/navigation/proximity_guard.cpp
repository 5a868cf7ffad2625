#include "sim/navigation/proximity_guard.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace castaway::sim {
namespace {

constexpr double kSideReach = 1.5;  // [m] Within which sides are compared.

}  // namespace

void ProximityGuard::on_scan(const LidarReading& scan, const LidarConfig& lidar) {
  if (points_.size() <= scan.lidar) points_.resize(scan.lidar + 1);
  std::vector<Eigen::Vector2d>& points = points_[scan.lidar];
  points.clear();
  const auto beams = static_cast<std::size_t>(lidar.beams);
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const double range = scan.ranges[i];
    if (!std::isfinite(range) || scan.hit_object[i] == kHitFloor) continue;
    const double angle = lidar.angle_min + lidar.angle_increment * static_cast<double>(i % beams);
    const double elevation = lidar.elevations[i / beams];
    const double level = range * std::cos(elevation);
    const Eigen::Vector3d p_laser(level * std::cos(angle), level * std::sin(angle),
                                  range * std::sin(elevation));
    points.emplace_back((lidar.T_base_laser * p_laser).head<2>());
  }
}

/// Way ahead until the disc of the robot meets a point.
double ProximityGuard::gap_ahead() const {
  double gap = std::numeric_limits<double>::infinity();
  for (const auto& points : points_) {
    for (const Eigen::Vector2d& p : points) {
      if (p.x() <= 0.0 || std::abs(p.y()) >= config_.radius) continue;
      const double front = std::sqrt(config_.radius * config_.radius - p.y() * p.y());
      gap = std::min(gap, p.x() - front);
    }
  }
  return gap;
}

double ProximityGuard::roomier_side() const {
  double balance = 0.0;
  for (const auto& points : points_) {
    for (const Eigen::Vector2d& p : points) {
      const double nearness = std::max(kSideReach - p.norm(), 0.0);
      balance -= nearness * p.normalized().y();
    }
  }
  return balance >= 0.0 ? 1.0 : -1.0;
}

Twist2 ProximityGuard::guarded(const Twist2& command) {
  const double room = gap_ahead() - config_.margin;
  const double allowed = room > 0.0 ? std::sqrt(2.0 * config_.deceleration * room) : 0.0;
  const bool blocked = room <= 0.0;
  const bool wants_ahead = command.v > 0.0 || escape_left_ > 0;
  if (blocked && wants_ahead) {
    if (escape_left_ == 0) escape_side_ = roomier_side();
    escape_left_ = config_.escape_calls;
    return {0.0, escape_side_ * config_.escape_turn_rate};
  }
  if (escape_left_ > 0) {
    --escape_left_;
    return {std::min(config_.escape_speed, allowed), 0.0};
  }
  if (command.v <= allowed) return command;
  return {allowed, command.w * allowed / command.v};
}

}  // namespace castaway::sim
