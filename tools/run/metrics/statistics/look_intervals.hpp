/// Intervals that hold at every look at a sample that grows.
#pragma once

#include <optional>
#include <vector>

#include "tools/run/metrics/statistics/intervals.hpp"
#include "tools/run/metrics/statistics/statistics.hpp"

namespace castaway::testbed {

/// Sizes of a sample at which it is looked at: `first`, then twice as many each time, and `most`.
std::vector<int> look_sizes(int first, int most);

/// Interval of a mean at one of `looks` looks. All of them together hold the mean with 95 %: each
/// has a confidence of 1 - 0.05 / looks (Bonferroni). Without this a sample that is looked at until
/// its interval is narrow misses the mean too often.
///
/// `shares`: values in [0, 1], whose variance is at most that of a coin with their mean; the
/// interval is Wilson's. Otherwise Student's; nothing for fewer than ten values or equal ones.
std::optional<Interval> mean_interval_at_look(const std::vector<double>& values, bool shares,
                                              int looks);

}  // namespace castaway::testbed
