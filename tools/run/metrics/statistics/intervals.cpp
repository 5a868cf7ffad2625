#include "tools/run/metrics/statistics/intervals.hpp"

#include <algorithm>
#include <cmath>

namespace castaway::testbed {

RateInterval wilson_interval(int successes, int trials) {
  constexpr double kZ = 1.959963984540054;  // 97.5 % quantile of the normal distribution
  return wilson_interval(successes, trials, kZ);
}

RateInterval wilson_interval(double successes, double trials, double z) {
  if (trials <= 0.0) return {};
  const double n = trials;
  const double p = successes / n;
  const double centre = (p + z * z / (2.0 * n)) / (1.0 + z * z / n);
  const double half = z / (1.0 + z * z / n) * std::sqrt(p * (1.0 - p) / n + z * z / (4.0 * n * n));
  return {std::max(0.0, centre - half), std::min(1.0, centre + half)};
}

}  // namespace castaway::testbed
