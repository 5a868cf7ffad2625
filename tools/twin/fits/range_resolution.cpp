#include "tools/twin/fits/range_resolution.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "tools/twin/alignment/expected_scan.hpp"

namespace castaway::testbed {
namespace {

std::vector<float> some_ranges(const AlignedLog& log) {
  std::vector<float> ranges;
  for (const std::size_t index : spread_scans(log, 100)) {
    const LaserScan& scan = log.scans[index].scan;
    for (const float r : scan.ranges) {
      if (std::isfinite(r) && r > 0.0F && r < 0.999 * scan.range_max) ranges.push_back(r);
    }
  }
  return ranges;
}

}  // namespace

double find_resolution(const std::vector<float>& ranges) {
  constexpr std::array kSteps = {0.1,   0.05,  0.04,   0.025, 0.02,  0.01,
                                 0.005, 0.004, 0.0025, 0.002, 0.001, 0.0005};
  constexpr double kNearly = 0.05;  // Of a step.
  constexpr double kMost = 0.99;
  if (ranges.empty()) return 0.0;
  for (const double step : kSteps) {
    const auto multiples = std::count_if(ranges.begin(), ranges.end(), [&](double r) {
      return std::abs(r / step - std::round(r / step)) < std::max(kNearly, 1e-6 * r / step);
    });
    if (static_cast<double>(multiples) >= kMost * static_cast<double>(ranges.size())) return step;
  }
  return 0.0;
}

double find_resolution(const AlignedLog& log) { return find_resolution(some_ranges(log)); }

}  // namespace castaway::testbed
