#include "tools/alignment/motion_samples.hpp"

#include <algorithm>
#include <cmath>

namespace castaway::testbed {
namespace {

constexpr double kLongestStep = 0.1;  // [s]

Leg take_leg(const AlignedLog& log, const AlignedScan& from, const AlignedScan& to, double track) {
  Leg leg;
  leg.T_start_end = from.T_map_base.inverse() * to.T_map_base;
  leg.breaks = to.breaks;
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
