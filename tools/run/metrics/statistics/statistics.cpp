#include "tools/run/metrics/statistics/statistics.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace castaway::testbed {

double percentile(const std::vector<double>& ascending, double q) {
  assert(!ascending.empty() && q >= 0.0 && q <= 1.0);
  const double place = q * static_cast<double>(ascending.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, ascending.size() - 1);
  const double fraction = place - static_cast<double>(below);
  return ascending[below] + fraction * (ascending[above] - ascending[below]);
}

std::optional<Statistics> statistics(std::vector<double> sample) {
  if (sample.empty()) return std::nullopt;
  std::sort(sample.begin(), sample.end());
  double sum = 0.0;
  double squares = 0.0;
  for (const double value : sample) {
    sum += value;
    squares += value * value;
  }
  const auto count = static_cast<double>(sample.size());
  return Statistics{sum / count,
                    percentile(sample, 0.5),
                    percentile(sample, 0.95),
                    std::sqrt(squares / count),
                    sample.back(),
                    {},
                    {}};
}

}  // namespace castaway::testbed
