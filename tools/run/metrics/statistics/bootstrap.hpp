/// Bootstrap confidence intervals of means and medians.
///
/// B. Efron, R. J. Tibshirani, "An Introduction to the Bootstrap", 1993, ch. 13 (percentile
/// intervals); H. R. Kuensch, "The Jackknife and the Bootstrap for General Stationary
/// Observations", Annals of Statistics 17, 1989, for blocks. Our blocks are circular. Blocks are
/// needed because errors of neighbouring scans are correlated; an interval that assumed
/// independence would be too narrow.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "tools/run/metrics/statistics/statistics.hpp"

namespace castaway::testbed {

/// Parameters of the resampling.
struct BootstrapConfig {
  std::string stream;     ///< Name of the substream of random numbers; its seed is fixed.
  std::size_t block = 1;  ///< Length of a block; 1 for an independent sample.
  int resamples = 1000;   ///< Number of resamples; the interval is their 2.5 % and 97.5 %
                          ///< quantiles.
};

/// 95 % intervals of a sample's mean and median, in the sample's unit.
struct BootstrapIntervals {
  Interval mean;
  Interval median;
};

/// Deterministic for a sample and a configuration. Nothing for fewer than two elements or fewer
/// than two blocks.
std::optional<BootstrapIntervals> bootstrap(const std::vector<double>& sample,
                                            const BootstrapConfig& config);

/// Statistics of a sample with their intervals; nothing for an empty sample.
std::optional<Statistics> statistics_with_intervals(std::vector<double> sample,
                                                    const BootstrapConfig& config);

}  // namespace castaway::testbed
