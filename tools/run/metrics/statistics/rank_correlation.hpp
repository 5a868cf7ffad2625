/// Agreement of two rankings.
#pragma once

#include <optional>
#include <vector>

namespace castaway::testbed {

/// M. G. Kendall's tau-b ("The Treatment of Ties in Ranking Problems", Biometrika 33, 1945) of the
/// pairs (x[i], y[i]): 1 for the same order, -1 for the reverse. Nothing if all x or all y are
/// equal. Values that differ by less than 1e-9 are equal. Both vectors have the same length.
std::optional<double> kendall_tau(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace castaway::testbed
