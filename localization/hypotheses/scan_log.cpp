#include "localization/hypotheses/scan_log.hpp"

#include <algorithm>
#include <utility>

namespace castaway::localization {

void ScanLog::start() {
  scans_.clear();
  recent_cue_ = 0.0;
}

const ScanMemory& ScanLog::add(const ScanPoints& points, const SE2& T_odom_base, double listed,
                               double null) {
  ScanMemory scan{points, T_odom_base, 1.0, listed, null, 0.0};
  if (!scans_.empty()) {
    const ScanMemory& before = scans_.back();
    scan.independence = independence(posterior_, distance(before.T_odom_base, T_odom_base),
                                     yaw_distance(before.T_odom_base, T_odom_base));
    const SE2 u = before.T_odom_base.inverse() * T_odom_base;
    scan.kidnap_cue = kidnap_cue(posterior_, scan_agreement(agreement_, before.points, points, u),
                                 scan.independence);
  }
  recent_cue_ = std::max(scan.kidnap_cue, recent_cue_ - scan.independence);
  scans_.push_back(std::move(scan));
  if (scans_.size() > most_) scans_.pop_front();
  return scans_.back();
}

std::optional<SE2> ScanLog::T_odom_base() const {
  if (scans_.empty()) return std::nullopt;
  return scans_.back().T_odom_base;
}

}  // namespace castaway::localization
