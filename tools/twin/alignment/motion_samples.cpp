#include "tools/twin/alignment/motion_samples.hpp"

#include <algorithm>
#include <cmath>

namespace castaway::testbed {
namespace {

constexpr double kLongestStep = 0.1;  // [s]

/// Zero where odometry is unknown.
OdometryRate rate_at(const AlignedLog& log, Stamp stamp, double track) {
  constexpr Stamp kHalf = std::chrono::milliseconds(50);
  const auto before = log.T_odom_base.at(stamp - kHalf);
  const auto after = log.T_odom_base.at(stamp + kHalf);
  if (!before || !after) return {};
  const OdometryStep step = step_of(before->inverse() * *after, track);
  const double time = 2.0 * seconds(kHalf);
  return {step.along / time, step.turn / time};
}

Leg take_leg(const AlignedLog& log, const AlignedScan& from, const AlignedScan& to, double track) {
  Leg leg;
  leg.T_start_end = from.T_map_base.inverse() * to.T_map_base;
  leg.breaks = to.breaks;
  leg.rate_at_start = rate_at(log, from.scan.stamp, track);
  leg.rate_at_end = rate_at(log, to.scan.stamp, track);
  const Stamp gap = to.scan.stamp - from.scan.stamp;
  const auto count =
      std::max<std::int64_t>(std::llround(std::ceil(seconds(gap) / kLongestStep)), 1);
  std::optional<SE2> before = log.T_odom_base.at(from.scan.stamp);
  for (std::int64_t k = 1; k <= count; ++k) {
    const std::optional<SE2> now = log.T_odom_base.at(from.scan.stamp + gap * k / count);
    if (!before || !now) {
      leg.breaks = true;
      return leg;
    }
    const SE2 u = before->inverse() * *now;
    before = now;
    if (u == SE2{}) continue;
    leg.steps.push_back(step_of(u, track));
    leg.way += leg.steps.back().way;
  }
  return leg;
}

}  // namespace

std::vector<Leg> take_legs(const AlignedLog& log, double track) {
  std::vector<Leg> legs;
  for (std::size_t i = 1; i < log.scans.size(); ++i) {
    legs.push_back(take_leg(log, log.scans[i - 1], log.scans[i], track));
  }
  return legs;
}

}  // namespace castaway::testbed
