#include "localization/sensor/intake.hpp"

#include <cmath>
#include <stdexcept>

namespace castaway::localization {
namespace {

bool is_finite(const SE2& pose) {
  return std::isfinite(pose.x) && std::isfinite(pose.y) && std::isfinite(pose.yaw);
}

bool has_numbers(const LaserScan& scan) {
  return std::isfinite(scan.angle_min) && std::isfinite(scan.angle_increment) &&
         scan.T_base_laser.matrix().allFinite();
}

}  // namespace

void validate(const PoseWithCovariance& start) {
  if (!is_finite(start.T_map_base) || !start.covariance.allFinite()) {
    throw std::invalid_argument("the start's pose or covariance is not a number");
  }
}

OdometryIntake Intake::take(const Odometry& odometry) {
  if (!is_finite(odometry.T_odom_base)) {
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
  if (late || !has_numbers(scan) || !T_odom_base_.at(scan.stamp)) {
    ++dropped_scans_;
    return false;
  }
  last_scan_[scan.lidar] = scan.stamp;
  return true;
}

}  // namespace castaway::localization
