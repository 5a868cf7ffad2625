#include "localization/input/intake.hpp"

#include <cmath>
#include <stdexcept>

namespace castaway::localization {
namespace {

constexpr double kFarthest = 1e7;       // [m] From the origin; UTM coordinates stay below.
constexpr double kFarthestMount = 1e3;  // [m] Of a lidar, from base.
constexpr double kMostAngle = 1e3;      // [rad]

/// True for finite poses that a robot can reach.
bool is_sane(const SE2& pose) {
  return std::abs(pose.x) <= kFarthest && std::abs(pose.y) <= kFarthest && std::isfinite(pose.yaw);
}

bool is_sane(const LaserScan& scan) {
  return std::abs(scan.angle_min) <= kMostAngle && std::abs(scan.angle_increment) <= kMostAngle &&
         (scan.T_base_laser.matrix().array().abs() <= kFarthestMount).all();
}

}  // namespace

void validate(const PoseWithCovariance& start) {
  const bool is_near = std::abs(start.z.value_or(0.0)) <= kFarthest;
  if (!is_sane(start.T_map_base) || !start.covariance.allFinite() || !is_near) {
    throw std::invalid_argument(
        "the start's pose or covariance is not a number, or beyond 1e7 m from the origin");
  }
}

OdometryIntake Intake::take(const Odometry& odometry) {
  if (!is_sane(odometry.T_odom_base)) {
    ++dropped_odometry_;
    return OdometryIntake::kDropped;
  }
  if (T_odom_base_.add(odometry.stamp, odometry.T_odom_base)) return OdometryIntake::kTaken;
  if (T_odom_base_.newest() - odometry.stamp < config_.set_back) {
    ++dropped_odometry_;
    return OdometryIntake::kDropped;
  }
  T_odom_base_.clear();
  last_scan_.clear();
  T_odom_base_.add(odometry.stamp, odometry.T_odom_base);
  return OdometryIntake::kRestarted;
}

bool Intake::accept(const LaserScan& scan) {
  const auto last = last_scan_.find(scan.lidar);
  const bool late = last != last_scan_.end() && scan.stamp <= last->second;
  if (late || !is_sane(scan) || !T_odom_base_.at(scan.stamp)) {
    ++dropped_scans_;
    return false;
  }
  last_scan_[scan.lidar] = scan.stamp;
  return true;
}

}  // namespace castaway::localization
