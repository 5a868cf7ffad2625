#include "sim/drive_stage.hpp"

#include <cmath>

#include "sim/drive_setup.hpp"
#include "sim/drive_space.hpp"

namespace castaway::sim {
namespace {

constexpr std::chrono::nanoseconds kPeriod = std::chrono::milliseconds(50);

}  // namespace

DriveStage::DriveStage(const SimulationConfig& config, const Grid& drive_grid)
    : wait_(std::llround(1e9 * config.drive.wait_s)), log_(config.drive.log) {
  if (config.drive.by_estimate) {
    navigator_.emplace(navigator_of(config.drive, config.robot), config.map);
  } else {
    route_.emplace(route_of(config.drive, config.robot),
                   FreeSpace(drive_grid, config.robot.footprint_radius + kDriveMargin));
  }
}

Twist2 DriveStage::command(std::chrono::nanoseconds now, const Pose2& T_map_base,
                           PeopleStage& people) {
  next_ += kPeriod;
  if (now < wait_) return {};
  if (!log_.empty()) return twist_at(log_, std::chrono::duration<double>(now).count());
  if (navigator_) return navigator_->command(believed_);
  return people.yielded(route_->command(T_map_base), *route_);
}

void DriveStage::on_odometry(const OdometryReading& reading) {
  if (navigator_) navigator_->on_odometry(reading);
}

void DriveStage::on_scan(const LidarReading& scan, const LidarConfig& lidar) {
  if (navigator_) navigator_->on_scan(scan, lidar);
}

std::vector<std::string> DriveStage::take_events() {
  return navigator_ ? navigator_->take_events() : std::vector<std::string>{};
}

}  // namespace castaway::sim
