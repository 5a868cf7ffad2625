#include "sim/events/lidar_faults.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "sim/common/seconds.hpp"

namespace castaway::sim {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr double kDegrees = 180.0 / std::numbers::pi;

/// Angle from `from` to `angle`, counter-clockwise. [deg] in [0, 360)
double degrees_from(double from, double angle) {
  const double way = std::fmod(angle - from, 360.0);
  return way < 0.0 ? way + 360.0 : way;
}

/// Width of the sector that a cover blocks; a full turn if its ends are one apart or more. [deg]
double sector_of(const FaultSpec& fault) {
  const bool full = std::abs(fault.to_deg - fault.from_deg) >= 360.0;
  return full ? 360.0 : degrees_from(fault.from_deg, fault.to_deg);
}

}  // namespace

LidarFaults::LidarFaults(const std::vector<FaultSpec>& faults, const LidarConfig& lidar, bool open)
    : lidar_(lidar), open_(open) {
  for (const FaultSpec& fault : faults) add(fault);
}

void LidarFaults::add(const FaultSpec& fault) {
  const bool meant = fault.lidar.empty() || fault.lidar == lidar_.name;
  if (meant && is_lidar_fault(fault.kind)) faults_.push_back(fault);
}

void LidarFaults::block(const FaultSpec& fault, LidarReading& reading) const {
  const bool near = fault.distance < lidar_.range_min;
  if (fault.distance > lidar_.range_max) return;
  const double sector = sector_of(fault);
  for (std::size_t i = 0; i < reading.ranges.size(); ++i) {
    const auto beam = static_cast<double>(i % static_cast<std::size_t>(lidar_.beams));
    const double angle = kDegrees * (lidar_.angle_min + beam * lidar_.angle_increment);
    // With a tolerance for rounding, so that the sector's last beam is blocked, too.
    if (degrees_from(fault.from_deg - 1e-9, angle) > sector + 2e-9) continue;
    reading.ranges[i] = near ? -kInfinity : static_cast<float>(fault.distance);
    reading.hit_object[i] = kHitCover;
    if (!reading.intensities.empty()) reading.intensities[i] = 0.0F;
  }
}

void LidarFaults::apply(const FaultSpec& fault, Sweep& sweep) const {
  LidarReading& reading = sweep.reading;
  if (fault.kind == FaultKind::kLidarBlocked) block(fault, reading);
  if (fault.kind == FaultKind::kLidarMount) reading.mount_error = fault.mount_error;
  if (fault.kind == FaultKind::kLidarLate) sweep.last_beam += to_nanoseconds(fault.delay_s);
  if (fault.kind == FaultKind::kLidarClock) reading.stamp += to_nanoseconds(fault.offset_s);
  if (fault.kind == FaultKind::kLidarFrozen && last_) {
    reading.ranges = last_->ranges;
    reading.hit_object = last_->hit_object;
    reading.intensities = last_->intensities;
  }
}

std::optional<Sweep> LidarFaults::deliver(Sweep sweep) {
  if (faults_.empty() && !open_) return sweep;
  const auto stamp = sweep.reading.stamp;
  bool frozen = false;
  for (const FaultSpec& fault : faults_) {
    if (!is_active(fault, stamp)) continue;
    if (fault.kind == FaultKind::kLidarDropout) return std::nullopt;
    frozen = frozen || fault.kind == FaultKind::kLidarFrozen;
  }
  if (!frozen) last_ = sweep.reading;
  for (const FaultSpec& fault : faults_) {
    if (is_active(fault, stamp)) apply(fault, sweep);
  }
  return sweep;
}

}  // namespace castaway::sim
