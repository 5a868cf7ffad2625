/// Bootstrap confidence intervals of means and medians.
///
/// B. Efron, R. J. Tibshirani, "An Introduction to the Bootstrap", 1993, ch. 13 (percentile
/// intervals); H. R. Kuensch, "The Jackknife and the Bootstrap for General Stationary
/// Observations", Annals of Statistics 17, 1989, for blocks, which we take circular: errors of
/// neighbouring scans resemble each other, and an interval that took them for independent would be
/// too narrow.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "tools/metrics/statistics/statistics.hpp"

namespace castaway::testbed {

/// How a sample is drawn anew.
struct BootstrapConfig {
  std::string stream;     ///< Names the substream of random numbers; its seed is fixed.
  std::size_t block = 1;  ///< Neighbours that are drawn together; 1: the sample is independent.
  int resamples = 1000;   ///< Samples drawn; the interval is their 2.5 % and 97.5 % quantiles.
};

/// 95 % intervals of a sample's mean and median, in the sample's unit.
struct BootstrapIntervals {
  Interval mean;
  Interval median;
};

/// Nothing of fewer than two elements, nor of fewer than two blocks. Same sample, same
/// configuration: same intervals.
std::optional<BootstrapIntervals> bootstrap(const std::vector<double>& sample,
                                            const BootstrapConfig& config);

/// Figures of a sample with their intervals; nothing for an empty sample.
std::optional<Statistics> statistics_with_intervals(std::vector<double> sample,
                                                    const BootstrapConfig& config);

}  // namespace castaway::testbed
