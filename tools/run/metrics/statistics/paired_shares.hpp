/// Two shares over the same trials.
#pragma once

#include "tools/run/metrics/statistics/statistics.hpp"

namespace castaway::testbed {

/// Outcomes of two methods in the same trials.
struct PairedOutcomes {
  int both = 0;
  int only_first = 0;   ///< Successes of the first method where the second one failed.
  int only_second = 0;  ///< The reverse.
  int neither = 0;

  void add(bool first, bool second);
  [[nodiscard]] int trials() const { return both + only_first + only_second + neither; }
  /// Share of the first method minus share of the second one; 0 without trials.
  [[nodiscard]] double difference() const;
};

/// Two-sided exact p-value of Q. McNemar's test ("Note on the sampling error of the difference
/// between correlated proportions or percentages", Psychometrika 12, 1947): under the null
/// hypothesis, each trial with one success is a fair coin.
double mcnemar_p_value(const PairedOutcomes& outcomes);

/// 95 % interval of the difference of the shares: Wald's, with half a trial added to each of the
/// four counts (A. Agresti, Y. Min, "Simple improved confidence intervals for comparing matched
/// proportions", Statistics in Medicine 24, 2005).
Interval paired_difference_interval(const PairedOutcomes& outcomes);

}  // namespace castaway::testbed
