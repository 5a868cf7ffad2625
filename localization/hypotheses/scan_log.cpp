#include "localization/hypotheses/scan_log.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace castaway::localization {

double independence(const ScanComparisonConfig& config, double moved_m, double turned_rad) {
  const double e = moved_m / config.independent_m + turned_rad / config.independent_rad;
  return std::clamp(e, config.least_independence, 1.0);
}

double kidnap_cue(const ScanComparisonConfig& config, const std::optional<double>& agreement,
                  double new_share) {
  constexpr double kMoves = 0.5;  // At this new share, the robot is no longer at rest.
  if (!agreement) return 0.0;
  const double rest =
      std::clamp((kMoves - new_share) / (kMoves - config.least_independence), 0.0, 1.0);
  const double against =
      config.agreeing_slope * (*agreement - config.agreeing) - config.agreeing_at_rest * rest;
  const double in_favour = config.disagreeing_slope * (config.disagreeing - *agreement);
  return std::max(0.0, in_favour) - std::max(0.0, against);
}

void ScanLog::start() {
  scans_.clear();
  continuity_.start();
  recent_cue_ = 0.0;
}

const ScanMemory& ScanLog::add(ScanMemory scan) {
  if (!scans_.empty()) compare(scans_.back(), scan);
  recent_cue_ = std::max(scan.arrival_cue, recent_cue_ - scan.independence);
  scans_.push_back(std::move(scan));
  if (scans_.size() > static_cast<std::size_t>(config_.most)) scans_.pop_front();
  return scans_.back();
}

void ScanLog::compare(const ScanMemory& before, ScanMemory& scan) {
  const SE2 u = before.T_odom_base.inverse() * scan.T_odom_base;
  scan.independence = independence(config_.comparison, u.translation().norm(), std::abs(u.yaw));
  const auto agreement = scan_agreement(config_.agreement, before.points, scan.points, u);
  scan.kidnap_cue = kidnap_cue(config_.comparison, agreement, scan.independence);
  const double jump = continuity_.take(before.points, scan.points, u);
  scan.arrival_cue = jump > 0.0 ? std::max(scan.kidnap_cue, jump) : scan.kidnap_cue;
}

std::optional<SE2> ScanLog::T_odom_base() const {
  if (scans_.empty()) return std::nullopt;
  return scans_.back().T_odom_base;
}

}  // namespace castaway::localization
