/// Descriptive statistics of a sample.
#pragma once

#include <optional>
#include <vector>

namespace castaway::testbed {

/// An interval in the unit of its quantity.
struct Interval {
  double low = 0.0;
  double high = 0.0;
};

/// Statistics in the sample's unit.
struct Statistics {
  double mean = 0.0;
  double median = 0.0;
  double p95 = 0.0;   ///< 95th percentile.
  double rmse = 0.0;  ///< Root of the mean square.
  double max = 0.0;
  std::optional<Interval> mean_interval{};    ///< 95 %; only if requested (bootstrap.hpp) and the
                                              ///< sample is large enough.
  std::optional<Interval> median_interval{};  ///< As `mean_interval`.
};

/// The `q` quantile, q in [0, 1], of an ascending, non-empty sample by linear interpolation: q = 0
/// is the first element, q = 1 the last (Hyndman and Fan's type 7, numpy's default).
double percentile(const std::vector<double>& ascending, double q);

/// Returns nothing for an empty sample.
std::optional<Statistics> statistics(std::vector<double> sample);

}  // namespace castaway::testbed
