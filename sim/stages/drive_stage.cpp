#include "sim/stages/drive_stage.hpp"

#include <algorithm>
#include <cmath>

#include "sim/common/seconds.hpp"
#include "sim/stages/drive_setup.hpp"
#include "sim/stages/drive_space.hpp"

namespace castaway::sim {
namespace {

constexpr std::chrono::nanoseconds kPeriod = std::chrono::milliseconds(50);
// [m] A larger error of the estimated pose excuses a lack of progress.
constexpr double kRightWithin = 0.15;
constexpr double kRightWithinYaw = 0.15;  // [rad] The same for its heading.
constexpr double kPersonInTheWay = 1.0;   // [m] A person this close to the robot may be in its way.

}  // namespace

DriveStage::DriveStage(const SimulationConfig& config, Spaces& spaces)
    : wait_(to_nanoseconds(config.drive.wait_s)),
      log_(config.drive.log),
      radius_(config.robot.footprint_radius) {
  if (config.drive.by_estimate) {
    navigator_.emplace(navigator_of(config.drive, config.robot), config.map);
  } else {
    route_.emplace(route_of(config.drive, config.robot),
                   spaces.driving(config, config.robot.footprint_radius + kDriveMargin));
  }
}

Twist2 DriveStage::command(std::chrono::nanoseconds now, const Pose2& T_map_base,
                           PeopleStage& people) {
  next_ += kPeriod;
  wants_ = false;
  if (command_) return *command_;
  if (now < wait_) return {};
  if (!log_.empty()) {
    const Twist2 twist = twist_at(log_, to_seconds(now));
    wants_ = twist.v != 0.0 || twist.w != 0.0;
    return twist;
  }
  const bool done = navigator_ ? navigator_->done() : route_->done();
  wants_ = !done && is_estimate_right(T_map_base) && !is_person_near(T_map_base, people);
  if (navigator_) return navigator_->command(estimate_);
  return people.yield_to_people(route_->command(T_map_base), *route_);
}

bool DriveStage::is_estimate_right(const Pose2& T_map_base) const {
  if (!navigator_) return true;
  if (!estimate_) return false;
  const Pose2 error = inverse(T_map_base) * *estimate_;
  return error.position().norm() < kRightWithin && std::abs(error.yaw) < kRightWithinYaw;
}

bool DriveStage::is_person_near(const Pose2& T_map_base, const PeopleStage& people) const {
  const std::vector<Eigen::Vector2d> positions = people.positions();
  return std::any_of(positions.begin(), positions.end(), [&](const Eigen::Vector2d& p_map) {
    return (p_map - T_map_base.position()).norm() < radius_ + kPersonInTheWay;
  });
}

void DriveStage::on_odometry(const OdometryReading& reading) {
  if (navigator_) navigator_->on_odometry(reading);
}

void DriveStage::on_scan(const LidarReading& scan, const LidarConfig& lidar) {
  if (navigator_) navigator_->on_scan(scan, lidar);
}

std::vector<Driving> DriveStage::take_events() {
  return navigator_ ? navigator_->take_events() : std::vector<Driving>{};
}

}  // namespace castaway::sim
