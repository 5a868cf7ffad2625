/// Figures that sum up a sample.
#pragma once

#include <optional>
#include <vector>

namespace castaway::testbed {

/// An interval in the unit of what it is of.
struct Interval {
  double low = 0.0;
  double high = 0.0;
};

/// A sample in five figures, in the sample's unit.
struct Statistics {
  double mean = 0.0;
  double median = 0.0;
  double p95 = 0.0;   ///< 95th percentile.
  double rmse = 0.0;  ///< Root of the mean square.
  double max = 0.0;
  std::optional<Interval> mean_interval{};    ///< 95 %, where one was asked for (bootstrap.hpp)...
  std::optional<Interval> median_interval{};  ///< ...and the sample is large enough.
};

/// The value below which a share `q` in [0, 1] of an ascending, non-empty sample lies: linear
/// between the elements, q = 0 the first, q = 1 the last (Hyndman and Fan's type 7, numpy's
/// default).
double percentile(const std::vector<double>& ascending, double q);

/// Nothing for an empty sample.
std::optional<Statistics> statistics(std::vector<double> sample);

}  // namespace castaway::testbed
