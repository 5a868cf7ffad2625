#include "tools/run/metrics/statistics/rank_correlation.hpp"

#include <cassert>
#include <cmath>
#include <cstddef>

namespace castaway::testbed {
namespace {

/// Sign of a difference; 0 for what is rounding.
int sign(double difference) {
  constexpr double kRounding = 1e-9;
  return (difference > kRounding) - (difference < -kRounding);
}

}  // namespace

std::optional<double> kendall_tau(const std::vector<double>& x, const std::vector<double>& y) {
  assert(x.size() == y.size());
  double agreeing = 0.0;
  double ordered_x = 0.0;
  double ordered_y = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t j = i + 1; j < x.size(); ++j) {
      const int in_x = sign(x[j] - x[i]);
      const int in_y = sign(y[j] - y[i]);
      agreeing += in_x * in_y;
      ordered_x += std::abs(in_x);
      ordered_y += std::abs(in_y);
    }
  }
  if (ordered_x == 0.0 || ordered_y == 0.0) return std::nullopt;
  return agreeing / std::sqrt(ordered_x * ordered_y);
}

}  // namespace castaway::testbed
