#include "tools/run/metrics/statistics/look_intervals.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

namespace castaway::testbed {
namespace {

constexpr double kMissedAtAnyLook = 0.05;

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

std::optional<Interval> student_interval(const std::vector<double>& values, double tail) {
  constexpr std::size_t kFewest = 10;
  if (values.size() < kFewest) return std::nullopt;
  const auto n = static_cast<double>(values.size());
  const double mean = mean_of(values);
  double squares = 0.0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  if (squares <= 0.0) return std::nullopt;
  const boost::math::students_t student(n - 1.0);
  const double half = boost::math::quantile(boost::math::complement(student, tail)) *
                      std::sqrt(squares / (n - 1.0) / n);
  return Interval{mean - half, mean + half};
}

}  // namespace

std::vector<int> look_sizes(int first, int most) {
  std::vector<int> sizes;
  for (int size = first; size < most; size *= 2) sizes.push_back(size);
  sizes.push_back(most);
  return sizes;
}

std::optional<Interval> mean_interval_at_look(const std::vector<double>& values, bool shares,
                                              int looks) {
  const double tail = 0.5 * kMissedAtAnyLook / looks;
  if (!shares) return student_interval(values, tail);
  if (values.empty()) return std::nullopt;
  const auto n = static_cast<double>(values.size());
  const double z = boost::math::quantile(boost::math::complement(boost::math::normal(), tail));
  const RateInterval rate = wilson_interval(mean_of(values) * n, n, z);
  return Interval{rate.low, rate.high};
}

}  // namespace castaway::testbed
