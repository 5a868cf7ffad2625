#include "tools/build/recorded/carmen_frames.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>

namespace castaway::testbed {
namespace {

constexpr double kRadPerDegree = std::numbers::pi / 180.0;

struct Angles {
  double min;
  double increment;
};

/// See carmen_source.hpp.
Angles flaser_angles(double fov_deg, double resolution_deg, std::size_t beams) {
  const double steps = beams > 1 ? static_cast<double>(beams - 1) : 1.0;
  const double start_deg = fov_deg > 180.0 ? 0.5 * fov_deg : 90.0;
  const bool fits =
      resolution_deg > 0.0 && std::abs(steps * resolution_deg - fov_deg) < 1.5 * resolution_deg;
  const double step_deg = fits ? resolution_deg : 2.0 * start_deg / steps;
  return {-start_deg * kRadPerDegree, step_deg * kRadPerDegree};
}

Angles device_angles(const CarmenLaser::Device& device, std::size_t beams) {
  const double steps = beams > 1 ? static_cast<double>(beams - 1) : 1.0;
  const bool given = device.angle_increment != 0.0;
  return {device.angle_min, given ? device.angle_increment : device.field_of_view / steps};
}

/// Converts CARMEN's maximum range for a miss to REP-117.
float to_range(float range, double range_max) {
  if (range >= static_cast<float>(range_max)) return std::numeric_limits<float>::infinity();
  return range > 0.0F ? range : std::numeric_limits<float>::quiet_NaN();
}

SE2 mount(const CarmenLaser& laser, double offset) {
  const SE2 T_base_laser = laser.T_odom_base.inverse() * laser.T_odom_laser;
  const bool differs =
      T_base_laser.translation().norm() > 1e-6 || std::abs(T_base_laser.yaw) > 1e-6;
  return differs ? T_base_laser : SE2{offset, 0.0, 0.0};
}

}  // namespace

void CarmenFrames::add(const CarmenMessage& message) {
  if (all_played() && !std::holds_alternative<CarmenTruth>(message)) {
    frames_of_last_scan_ = 0;  // No truth can follow.
    return;
  }
  if (const auto* param = std::get_if<CarmenParam>(&message)) {
    params_[param->name] = param->value;
  } else if (const auto* odometry = std::get_if<CarmenOdometry>(&message)) {
    frames_of_last_scan_ = 0;
    add_odometry(odometry->time_s, odometry->T_odom_base);
  } else if (const auto* laser = std::get_if<CarmenLaser>(&message)) {
    add_laser(*laser);
  } else {
    add_truth(std::get<CarmenTruth>(message));
  }
}

bool CarmenFrames::all_played() const { return config_.scans && scans_played_ >= *config_.scans; }

bool CarmenFrames::complete() const { return all_played() && frames_of_last_scan_ == 0; }

bool CarmenFrames::is_selected(std::int64_t scan) const {
  using Scans = CarmenSourceConfig::Scans;
  if (scan < config_.from_scan) return false;
  return config_.selection == Scans::kAll || (scan % 2 == 0) == (config_.selection == Scans::kEven);
}

void CarmenFrames::add_odometry(double time_s, const SE2& T_odom_base) {
  const Stamp stamp = monotonic(time_s);
  if (scans_played_ == 0) return;
  frames_.push_back({stamp, OdometryFrame{{stamp, T_odom_base}, std::nullopt}});
}

void CarmenFrames::add_laser(const CarmenLaser& laser) {
  const Stamp stamp = monotonic(laser.time_s);
  const bool selected = is_selected(scans_seen_++);
  frames_of_last_scan_ = 0;
  if (!selected && scans_played_ == 0) return;
  frames_.push_back({stamp, OdometryFrame{{stamp, laser.T_odom_base}, std::nullopt}});
  frames_of_last_scan_ = 1;
  if (!selected) return;
  frames_.push_back({stamp, ScanFrame{make_scan(laser, stamp), std::nullopt}});
  frames_of_last_scan_ = 2;
  ++scans_played_;
}

void CarmenFrames::add_truth(const CarmenTruth& truth) {
  for (; frames_of_last_scan_ > 0; --frames_of_last_scan_) {
    Frame& frame = frames_[frames_.size() - frames_of_last_scan_];
    if (auto* odometry = std::get_if<OdometryFrame>(&frame.data)) {
      odometry->true_pose = truth.T_map_base;
    } else {
      std::get<ScanFrame>(frame.data).true_pose = truth.T_map_base;
    }
  }
}

LaserScan CarmenFrames::make_scan(const CarmenLaser& laser, Stamp stamp) const {
  const Angles angles =
      laser.device ? device_angles(*laser.device, laser.ranges.size())
                   : flaser_angles(param("laser_front_laser_fov", 180.0),
                                   param("laser_front_laser_resolution", 0.0), laser.ranges.size());
  LaserScan scan;
  scan.stamp = stamp;
  scan.angle_min = angles.min;
  scan.angle_increment = angles.increment;
  scan.range_max = laser.device ? laser.device->range_max
                                : param("robot_front_laser_max", config_.fallback_range_max);
  scan.ranges.reserve(laser.ranges.size());
  for (const float range : laser.ranges) scan.ranges.push_back(to_range(range, scan.range_max));
  scan.T_base_laser = localization::to_se3(mount(laser, param("robot_frontlaser_offset", 0.0)));
  scan.T_base_laser.translation().z() = config_.lidar_height;
  return scan;
}

double CarmenFrames::param(const std::string& name, double fallback) const {
  const auto found = params_.find(name);
  if (found == params_.end()) return fallback;
  double value = fallback;
  const std::string& text = found->second;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  return result.ec == std::errc{} && std::abs(value) <= 1e7 ? value : fallback;
}

Stamp CarmenFrames::monotonic(double time_s) {
  if (!first_time_s_) first_time_s_ = time_s;
  const Stamp stamp(std::llround((time_s - *first_time_s_) * 1e9));
  if (stamp < last_stamp_) ++repaired_stamps_;
  last_stamp_ = std::max(stamp, last_stamp_);
  return last_stamp_;
}

}  // namespace castaway::testbed
