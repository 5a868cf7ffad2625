#include "tools/twin/odometry/slip_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace castaway::testbed {
namespace {

/// Counts of one block of the log.
struct SlipTally {
  double way_m = 0.0;
  double ahead = 0.0;
  double behind = 0.0;
  double excess_m = 0.0;  ///< [m] What one wheel turned too far; less where odometry is behind.

  void add(const SlipTally& other) {
    way_m += other.way_m;
    ahead += other.ahead;
    behind += other.behind;
    excess_m += other.excess_m;
  }
  /// Slips per metre that each of two wheels travels.
  [[nodiscard]] double rate() const {
    return way_m > 0.0 ? std::max(ahead - behind, 0.0) / (2.0 * way_m) : 0.0;
  }
};

void tally(const Stretch& stretch, const DriveErrors& errors, const OdometryNoise& noise,
           double track, SlipTally& sum) {
  constexpr double kClear = 4.0;      // Standard deviations.
  constexpr double kLeastYaw = 0.02;  // [rad]
  sum.way_m += stretch.way;
  const SE2 miss = miss_of(stretch, errors);
  const double limit = kClear * std::sqrt(noise.variances(stretch)(2));
  if (std::abs(miss.yaw) < std::max(limit, kLeastYaw)) return;
  const double sign = miss.x > 0.0 ? 1.0 : -1.0;
  (miss.x > 0.0 ? sum.ahead : sum.behind) += 1.0;
  sum.excess_m += sign * std::abs(miss.yaw) * track;
}

}  // namespace

SlipFit fit_slips(const std::vector<Stretch>& stretches, const DriveErrors& errors,
                  const OdometryNoise& noise, double track, const Blocks& blocks) {
  std::array<SlipTally, Blocks::kCount> parts;
  for (const Stretch& s : stretches) {
    tally(s, errors, noise, track, parts[s.leg * Blocks::kCount / blocks.items()]);
  }
  const auto total = [&](std::size_t left_out) {
    SlipTally sum;
    for (std::size_t k = 0; k < parts.size(); ++k) {
      if (k != left_out) sum.add(parts[k]);
    }
    return sum;
  };
  const SlipTally all = total(Blocks::kCount);
  SlipFit fit;
  fit.rate_per_m =
      jackknife([&](std::size_t left_out) { return std::vector{total(left_out).rate()}; }).front();
  constexpr double kRuleOfThree = 3.0;  // 95 % limit of a count of none.
  fit.rate_per_m.interval.low = std::max(fit.rate_per_m.interval.low, 0.0);
  fit.rate_per_m.interval.high =
      std::max(fit.rate_per_m.interval.high, kRuleOfThree / (2.0 * std::max(all.way_m, 1.0)));
  fit.slips = static_cast<int>(std::max(all.ahead - all.behind, 0.0));
  if (fit.slips > 0 && all.excess_m > 0.0) {
    const double excess = all.excess_m / fit.slips;
    fit.length_m = excess * (1.0 - SlipFit::kShare) / SlipFit::kShare;
  }
  return fit;
}

}  // namespace castaway::testbed
