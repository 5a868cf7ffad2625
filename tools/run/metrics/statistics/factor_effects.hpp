/// How much of the variance of an outcome each factor of an experiment explains.
#pragma once

#include <cstddef>
#include <vector>

#include "tools/run/metrics/statistics/statistics.hpp"

namespace castaway::testbed {

/// Sobol indices of a factor: shares of the outcome's variance (I. M. Sobol, "Global sensitivity
/// indices for nonlinear mathematical models", Mathematics and Computers in Simulation 55, 2001).
struct FactorEffect {
  double first = 0.0;         ///< Explained by the factor alone.
  double total = 0.0;         ///< By the factor and everything that it interacts with.
  Interval first_interval{};  ///< 95 %, by a bootstrap over the seeds.
  Interval total_interval{};
};

/// Outcomes of all combinations of some factors' values, each with the same seeds.
struct FactorialOutcomes {
  std::vector<int> levels;  ///< Values of each factor.
  /// By combination, the last factor varying fastest, then by seed.
  std::vector<std::vector<double>> values;
};

/// Analysis of variance: the effect of each factor, then that of the seed, which stands for chance.
/// The factors' values are all that there are, the seeds a sample. Nothing if fewer than two seeds
/// or no variance is there.
std::vector<FactorEffect> factorial_effects(const FactorialOutcomes& outcomes);

/// Outcomes of two samples of the factors, and of the first one with one factor after the other
/// taken from the second one; all of one length.
struct SwappedOutcomes {
  std::vector<double> first;
  std::vector<double> second;
  std::vector<std::vector<double>> swapped;  ///< By factor.
};

/// The effect of each factor by the estimators of M. J. W. Jansen ("Analysis of variance designs
/// for model output", Computer Physics Communications 117, 1999). Nothing if fewer than two values
/// or no variance is there.
std::vector<FactorEffect> swapped_effects(const SwappedOutcomes& outcomes);

}  // namespace castaway::testbed
