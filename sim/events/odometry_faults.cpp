#include "sim/events/odometry_faults.hpp"

#include <algorithm>

#include "sim/common/seconds.hpp"

namespace castaway::sim {

OdometryFaults::OdometryFaults(const std::vector<FaultSpec>& faults) {
  for (const FaultSpec& fault : faults) add(fault);
}

void OdometryFaults::add(const FaultSpec& fault) {
  if (is_lidar_fault(fault.kind)) return;
  (fault.kind == FaultKind::kOdometryReset ? resets_ : faults_).push_back(fault);
}

WheelGain OdometryFaults::gain(std::chrono::nanoseconds stamp) const {
  WheelGain gain;
  for (const FaultSpec& fault : faults_) {
    if (!is_active(fault, stamp)) continue;
    const bool reversed = fault.kind == FaultKind::kOdometryReversed;
    double both = 1.0;
    if (fault.kind == FaultKind::kOdometryFrozen) both = 0.0;
    if (fault.kind == FaultKind::kOdometryScale) both = fault.scale;
    gain.left *= reversed && !fault.reverse_right ? -1.0 : both;
    gain.right *= reversed && fault.reverse_right ? -1.0 : both;
  }
  return gain;
}

bool OdometryFaults::is_lost(std::chrono::nanoseconds stamp) const {
  return std::any_of(faults_.begin(), faults_.end(), [stamp](const FaultSpec& fault) {
    return fault.kind == FaultKind::kOdometryDropout && is_active(fault, stamp);
  });
}

bool OdometryFaults::reset_due(std::chrono::nanoseconds stamp) {
  const double now_s = to_seconds(stamp);
  const auto due = std::remove_if(resets_.begin(), resets_.end(),
                                  [now_s](const FaultSpec& fault) { return now_s >= fault.at_s; });
  const bool any = due != resets_.end();
  resets_.erase(due, resets_.end());
  return any;
}

}  // namespace castaway::sim
