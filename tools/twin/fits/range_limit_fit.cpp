#include "tools/twin/fits/range_limit_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "tools/twin/alignment/expected_scan.hpp"

namespace castaway::testbed {
namespace {

constexpr std::size_t kLimitScans = 2000;
constexpr double kBeyondLimit = 1.02;     // Of the greatest range; less is the map's error.
constexpr double kBelowLimit = 0.8;       // Of the greatest range.
constexpr double kBeforeLimitWall = 0.4;  // [m] What returns earlier is not the wall.

bool is_measured(const LaserScan& scan, double r) {
  return std::isfinite(r) && r >= scan.range_min && r < scan.range_max;
}

double greatest_range(const AlignedLog& log) {
  double greatest = 0.0;
  for (const std::size_t i : spread_scans(log, kLimitScans)) {
    const LaserScan& scan = log.scans[i].scan;
    for (const double r : scan.ranges) {
      if (is_measured(scan, r)) greatest = std::max(greatest, r);
    }
  }
  return greatest;
}

/// Beams on walls of the map, most of them near the greatest range.
struct LimitCounts {
  std::vector<RangeLimitFit::Bin> bins;
  double returned_within = 0.0;
  double lost_within = 0.0;
  std::size_t lost_beyond = 0;
  double nearest_beyond = std::numeric_limits<double>::infinity();  ///< [m] Of the lost ones.
};

void count_bin(double wall, bool lost, double greatest, std::vector<RangeLimitFit::Bin>& bins) {
  constexpr double kBinsToLimit = 10.0;
  const double width = greatest / kBinsToLimit;
  const auto index = static_cast<std::size_t>(wall / width);
  while (bins.size() <= index) bins.push_back({(static_cast<double>(bins.size()) + 0.5) * width});
  bins[index].beams += 1.0;
  bins[index].returned += lost ? 0.0 : 1.0;
}

void count_limit(const LaserScan& scan, const std::vector<ExpectedBeam>& expected, double greatest,
                 LimitCounts& counts) {
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const double r = scan.ranges[i];
    const double wall = expected[i].range;
    if (!expected[i].wall) continue;
    if (std::isnan(r) || r < std::max(scan.range_min, wall - kBeforeLimitWall)) continue;
    const bool lost = !is_measured(scan, r);
    count_bin(wall, lost, greatest, counts.bins);
    if (wall < kBelowLimit * greatest) continue;
    if (wall <= greatest) (lost ? counts.lost_within : counts.returned_within) += 1.0;
    if (!lost || wall <= kBeyondLimit * greatest) continue;
    ++counts.lost_beyond;
    counts.nearest_beyond = std::min(counts.nearest_beyond, wall);
  }
}

}  // namespace

std::optional<RangeLimitFit> fit_range_limit(const AlignedLog& log) {
  constexpr std::size_t kFewestBeyond = 50;
  constexpr double kReturnedWithin = 0.2;  // Share.
  const double greatest = greatest_range(log);
  if (greatest <= 0.0) return std::nullopt;
  LimitCounts counts;
  for (const std::size_t i : spread_scans(log, kLimitScans)) {
    const LaserScan& scan = log.scans[i].scan;
    if (kBeyondLimit * greatest >= scan.range_max) return std::nullopt;
    count_limit(scan, expect_scan(log, log.scans[i], scan.range_max), greatest, counts);
  }
  const double within = counts.returned_within + counts.lost_within;
  if (counts.lost_beyond < kFewestBeyond) return std::nullopt;
  if (within == 0.0 || counts.returned_within < kReturnedWithin * within) return std::nullopt;
  return RangeLimitFit{
      {greatest, {greatest, counts.nearest_beyond}}, counts.lost_beyond, std::move(counts.bins)};
}

}  // namespace castaway::testbed
