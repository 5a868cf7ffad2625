#include "localization/sensor/scan_continuity.hpp"

#include <algorithm>
#include <cmath>

namespace castaway::localization {

void ScanContinuity::start() {
  usual_ = 1.0;
  spread_ = config_.spread_start;
  learned_ = 0;
}

double ScanContinuity::take(const ScanPoints& before, const ScanPoints& now,
                            const SE2& T_before_now) {
  const double moved = T_before_now.translation().norm();
  const double turned = std::abs(T_before_now.yaw);
  if (moved > config_.most_moved || turned > config_.most_turned) return 0.0;
  ScanAgreementConfig agreement = config_.agreement;
  agreement.tolerance += config_.tolerance_per_m * moved;
  agreement.tolerance_share += config_.tolerance_per_rad * turned;
  const std::optional<double> share = scan_agreement(agreement, before, now, T_before_now);
  if (!share) return 0.0;
  if (learned_ == 0) usual_ = *share;
  const double less = (usual_ - *share) / spread_;
  learn(*share - usual_);
  return std::clamp(less - config_.free, 0.0, config_.most);
}

void ScanContinuity::learn(double deviation) {
  constexpr int kStart = 2;  // The initial values count as this many scans.
  const double most = config_.limit * spread_;
  const double counted = std::clamp(deviation, -most, most);
  const double rate = std::max(config_.rate, 1.0 / (kStart + ++learned_));
  usual_ += rate * counted;
  spread_ += rate * (std::abs(counted) - spread_);
  spread_ = std::max(spread_, config_.least_spread);
}

}  // namespace castaway::localization
