#include "tools/twin/fits/wall_fit.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tools/run/metrics/statistics/statistics.hpp"
#include "tools/twin/alignment/expected_scan.hpp"

namespace castaway::testbed {
namespace {

/// How far behind the border of a cell a beam ended.
struct WallSample {
  std::size_t cell = 0;
  double along_beam = 0.0;    ///< [m]
  double along_normal = 0.0;  ///< [m]
};

std::vector<WallSample> take_samples(const AlignedLog& log, const SE2& T_base_moved,
                                     std::size_t most) {
  constexpr double kLargest = 0.5;  // [m] Farther off is another thing.
  std::vector<WallSample> samples;
  for (const std::size_t i : spread_scans(log, most)) {
    AlignedScan aligned = log.scans[i];
    aligned.T_map_base = aligned.T_map_base * T_base_moved;
    const LaserScan& scan = aligned.scan;
    const auto expected = expect_scan(log, aligned, std::min(scan.range_max, 40.0));
    for (std::size_t k = 0; k < expected.size(); ++k) {
      const double offset = scan.ranges[k] - expected[k].range;
      if (!expected[k].straight || !(std::abs(offset) < kLargest)) continue;
      samples.push_back({expected[k].cell, offset, offset * expected[k].cosine});
    }
  }
  return samples;
}

WallOffsets average(const localization::GridFrame& frame, const std::vector<WallSample>& samples,
                    double usual) {
  constexpr double kNearWall = 0.2;  // [m]
  WallOffsets walls(frame, usual);
  for (const WallSample& sample : samples) {
    if (std::abs(sample.along_beam - usual) < kNearWall) {
      walls.add(sample.cell, sample.along_normal);
    }
  }
  return walls;
}

double median_offset(const std::vector<WallSample>& samples) {
  std::vector<double> offsets;
  for (const WallSample& sample : samples) offsets.push_back(sample.along_normal);
  std::sort(offsets.begin(), offsets.end());
  return offsets.empty() ? 0.0 : percentile(offsets, 0.5);
}

/// The lowest point of the parabola through the values at -step, 0 and step; within the step.
double lowest(double below, double middle, double above, double step) {
  const double curvature = below - 2.0 * middle + above;
  if (curvature <= 0.0) return below < above ? -step : step;
  return std::clamp(0.5 * step * (below - above) / curvature, -step, step);
}

}  // namespace

WallOffsets learn_walls(const AlignedLog& log, double usual) {
  constexpr std::size_t kMostScans = 4000;
  return average(log.grid.frame, take_samples(log, {}, kMostScans), usual);
}

double wall_variance(const AlignedLog& log, const SE2& T_base_moved) {
  constexpr std::size_t kMostScans = 1500;
  constexpr double kLargest = 0.1;  // [m]
  const std::vector<WallSample> samples = take_samples(log, T_base_moved, kMostScans);
  const WallOffsets walls = average(log.grid.frame, samples, median_offset(samples));
  double sum = 0.0;
  for (const WallSample& sample : samples) {
    const double off = std::abs(sample.along_normal - walls.at(sample.cell));
    sum += std::pow(std::min(off, kLargest), 2.0);
  }
  return sum / static_cast<double>(std::max<std::size_t>(samples.size(), 1));
}

bool looks_around(const AlignedLog& log) {
  constexpr double kAround = 1.5 * std::numbers::pi;
  if (log.scans.empty()) return false;
  const LaserScan& scan = log.scans.front().scan;
  const auto beams = static_cast<double>(scan.ranges.size());
  return beams * std::abs(scan.angle_increment) >= kAround;
}

void sharpen_walls(AlignedLog& log) {
  constexpr double kStep = 0.03;  // [m]
  const double middle = wall_variance(log, {});
  const double x = lowest(wall_variance(log, {-kStep, 0.0, 0.0}), middle,
                          wall_variance(log, {kStep, 0.0, 0.0}), kStep);
  const double y = lowest(wall_variance(log, {0.0, -kStep, 0.0}), middle,
                          wall_variance(log, {0.0, kStep, 0.0}), kStep);
  const SE2 T_base_sharp{x, y, 0.0};
  for (AlignedScan& aligned : log.scans) aligned.T_map_base = aligned.T_map_base * T_base_sharp;
  log.T_start_base = log.T_start_base * T_base_sharp;
}

}  // namespace castaway::testbed
