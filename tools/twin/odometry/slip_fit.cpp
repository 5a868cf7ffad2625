#include "tools/twin/odometry/slip_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

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

constexpr double kClearSlip = 4.0;      // Standard deviations.
constexpr double kLeastSlipYaw = 0.02;  // [rad] Of a clear slip.

/// Standard deviation of a stretch's yaw, not below that of which the least clear one is a
/// multiple. [rad]
double yaw_sigma(const Stretch& stretch, const OdometryNoise& noise) {
  return std::max(std::sqrt(noise.variances(stretch)(2)), kLeastSlipYaw / kClearSlip);
}

void tally(const Stretch& stretch, const DriveErrors& errors, const OdometryNoise& noise,
           double track, SlipTally& sum) {
  sum.way_m += stretch.way;
  const SE2 miss = miss_of(stretch, errors);
  if (std::abs(miss.yaw) < kClearSlip * yaw_sigma(stretch, noise)) return;
  const double sign = miss.x > 0.0 ? 1.0 : -1.0;
  (miss.x > 0.0 ? sum.ahead : sum.behind) += 1.0;
  sum.excess_m += sign * std::abs(miss.yaw) * track;
}

/// Share of a normal distribution with mean `mean` and variance 1 that is farther than `x` from 0.
double share_beyond(double x, double mean) {
  const double root = std::numbers::sqrt2;
  return 0.5 * (std::erfc((x - mean) / root) + std::erfc((x + mean) / root));
}

/// Share of stretches like this one that noise and slips turn by more than `sigmas`.
double modelled_beyond(double sigmas, const Stretch& stretch, const OdometryNoise& noise,
                       double track, const SlipFit& fit) {
  const double sigma = yaw_sigma(stretch, noise);
  const double noise_only = std::sqrt(noise.variances(stretch)(2)) / sigma;
  const double slipped = 1.0 - std::exp(-2.0 * fit.rate_per_m.value * stretch.way);
  const double turn = fit.length_m * SlipFit::kShare / (1.0 - SlipFit::kShare) / track;
  if (noise_only <= 0.0) return turn > sigmas * sigma ? slipped : 0.0;
  const double x = sigmas / noise_only;
  return (1.0 - slipped) * share_beyond(x, 0.0) +
         slipped * share_beyond(x, turn / sigma / noise_only);
}

std::vector<SlipFit::Tail> slip_tail(const std::vector<Stretch>& stretches,
                                     const DriveErrors& errors, const OdometryNoise& noise,
                                     double track, const SlipFit& fit) {
  constexpr int kTails = 24;
  constexpr double kStep = 0.5;  // Standard deviations.
  std::vector<SlipFit::Tail> tail(kTails);
  const double each = 1.0 / static_cast<double>(std::max<std::size_t>(stretches.size(), 1));
  for (std::size_t k = 0; k < tail.size(); ++k) tail[k].sigmas = kStep * static_cast<double>(k);
  for (const Stretch& s : stretches) {
    const double off = std::abs(miss_of(s, errors).yaw) / yaw_sigma(s, noise);
    for (SlipFit::Tail& t : tail) {
      t.measured += off > t.sigmas ? each : 0.0;
      t.model += each * modelled_beyond(t.sigmas, s, noise, track, fit);
    }
  }
  return tail;
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
  fit.tail = slip_tail(stretches, errors, noise, track, fit);
  return fit;
}

}  // namespace castaway::testbed
