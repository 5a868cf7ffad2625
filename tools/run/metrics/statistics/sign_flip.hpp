/// Significance test of a mean difference over pairs.
///
/// R. A. Fisher, "The Design of Experiments", 1935, section 21: under the null hypothesis, the
/// difference of each pair has either sign with equal probability. S. Holm, "A Simple Sequentially
/// Rejective Multiple Test Procedure", Scandinavian Journal of Statistics 6, 1979, for several
/// tests at once.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace castaway::testbed {

/// Two-sided p-value of the mean of `differences`: the share of all sign flips whose mean is at
/// least as far from zero. Exact for up to 16 pairs. For more, it is estimated from 20000 flips
/// drawn from the substream `stream`; the observed signs count as one of them, so the result is
/// never 0. 1 if there are no pairs.
double sign_flip_p_value(const std::vector<double>& differences, const std::string& stream);

/// p-values below it are significant.
inline constexpr double kSignificance = 0.05;

/// The smallest p-value that `pairs` pairs can have: the one of differences with the same sign.
double smallest_sign_flip_p_value(std::size_t pairs);

/// The number of pairs from which on one of `tests` tests can be significant after Holm's
/// correction.
std::size_t pairs_for_significance(std::size_t tests);

/// Holm's correction, in the given order. It bounds the probability of any false positive:
/// rejecting the null hypotheses with a corrected p-value below 0.05 makes that probability at most
/// 0.05.
std::vector<double> holm(const std::vector<double>& p_values);

}  // namespace castaway::testbed
