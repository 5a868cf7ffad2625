#include "tools/sources/bag/bag_truth.hpp"

#include <iterator>

namespace castaway::testbed {
namespace {

constexpr Stamp kTruthGap = std::chrono::milliseconds(500);  // Longest gap over which truth is
                                                             // interpolated.
constexpr double kTruthJump = 0.5;                           // [m] A longer step is a kidnap and is
                                                             // not interpolated.

}  // namespace

std::optional<SE2> BagTruth::at(Stamp stamp) const {
  const auto after = poses_.lower_bound(stamp);
  if (after == poses_.end()) return std::nullopt;
  if (after->first == stamp) return after->second;
  if (after == poses_.begin()) return std::nullopt;
  const auto before = std::prev(after);
  const Stamp gap = after->first - before->first;
  if (gap > kTruthGap || localization::distance(before->second, after->second) > kTruthJump) {
    return std::nullopt;
  }
  const double fraction = seconds(stamp - before->first) / seconds(gap);
  return localization::interpolate(before->second, after->second, fraction);
}

std::optional<SE2> BagTruth::of_scan(Stamp stamp) const {
  const auto exact = of_scans_.find(stamp);
  return exact != of_scans_.end() ? std::optional(exact->second) : at(stamp);
}

}  // namespace castaway::testbed
