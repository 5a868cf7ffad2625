#include "tools/twin/fits/stamp_fit.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace castaway::testbed {

StampFit fit_stamps(const std::vector<Stamp>& stamps) {
  assert(stamps.size() >= 2);
  constexpr double kGap = 1.5;
  constexpr double kQuartilesToSigma = 0.7413;  // Of a normal distribution.
  std::vector<double> periods;
  for (std::size_t i = 1; i < stamps.size(); ++i) {
    periods.push_back(seconds(stamps[i] - stamps[i - 1]));
  }
  std::sort(periods.begin(), periods.end());
  const double median = percentile(periods, 0.5);
  StampFit fit;
  fit.rate_hz = median > 0.0 ? 1.0 / median : 0.0;
  fit.longest_s = periods.back();
  const auto gap = std::upper_bound(periods.begin(), periods.end(), kGap * median);
  fit.gap_share = static_cast<double>(periods.end() - gap) / static_cast<double>(periods.size());
  const std::vector<double> regular(periods.begin(), gap);
  if (!regular.empty()) {
    fit.jitter_s = kQuartilesToSigma * (percentile(regular, 0.75) - percentile(regular, 0.25));
  }
  return fit;
}

}  // namespace castaway::testbed
