/// Is a mean difference over pairs more than chance?
///
/// R. A. Fisher, "The Design of Experiments", 1935, section 21: if nothing differs, each pair's
/// difference is as likely of either sign. S. Holm, "A Simple Sequentially Rejective Multiple Test
/// Procedure", Scandinavian Journal of Statistics 6, 1979, for many such questions at once.
#pragma once

#include <string>
#include <vector>

namespace castaway::testbed {

/// Two-sided p-value of the mean of `differences`: the share of all flips of their signs that leave
/// a mean as far from zero. Exact up to 16 pairs; beyond, of 20000 flips drawn from the substream
/// named `stream`, those as drawn included, so that it is never 0. 1 for no pairs.
double sign_flip_p_value(const std::vector<double>& differences, const std::string& stream);

/// Holm's correction, in the order given: where it is below 0.05 for some, the probability that
/// any of these is chance is below 0.05.
std::vector<double> holm(const std::vector<double>& p_values);

}  // namespace castaway::testbed
