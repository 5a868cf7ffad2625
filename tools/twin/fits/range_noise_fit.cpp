#include "tools/twin/fits/range_noise_fit.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>
#include <boost/math/distributions/chi_squared.hpp>

#include "tools/twin/alignment/expected_scan.hpp"
#include "tools/twin/fits/range_resolution.hpp"

namespace castaway::testbed {
namespace {

constexpr std::size_t kNoiseScans = 1000;
constexpr std::size_t kBeams = 7;          // In a group,
constexpr double kFreedom = kBeams - 2.0;  // less two parameters of the line.
constexpr double kNearWall = 0.25;         // [m] Farther from the map's wall it is something else.
constexpr std::size_t kNoiseBins = 10;
constexpr std::size_t kFewestInBin = 20;
/// Quantile of the groups' variances that is compared with chi squared: low, because groups at
/// edges are too large.
constexpr double kGroupQuantile = 0.35;

/// A group of beams on a straight wall.
struct Group {
  double range_m = 0.0;
  double variance = 0.0;  ///< [m^2]
  std::size_t scan = 0;   ///< Index of its scan in the log.
};

/// Residuals of a range from the map, of one beam in the middle of a group.
struct Residual {
  double value = 0.0;
  std::size_t scan = 0;
};

/// Variance of the ranges about the line that fits them: 1 / r is linear in cosine and sine.
/// Residuals are scaled to the range, so that all of the group count the same.
double variance_about_line(const LaserScan& scan, std::size_t first) {
  Eigen::Matrix<double, kBeams, 2> A;
  Eigen::Matrix<double, kBeams, 1> b;
  const double middle = scan.beam_angle(first + kBeams / 2);
  for (std::size_t k = 0; k < kBeams; ++k) {
    const double r = scan.ranges[first + k];
    const double angle = scan.beam_angle(first + k) - middle;
    const auto row = static_cast<Eigen::Index>(k);
    A.row(row) << r * std::cos(angle), r * std::sin(angle);
    b(row) = 1.0;
  }
  // r (a cos + b sin) - 1 is the relative error of a range; times r it is the error.
  const Eigen::Vector2d line = (A.transpose() * A).ldlt().solve(A.transpose() * b);
  const Eigen::Matrix<double, kBeams, 1> relative = A * line - b;
  double squares = 0.0;
  for (std::size_t k = 0; k < kBeams; ++k) {
    const double error = relative(static_cast<Eigen::Index>(k)) * scan.ranges[first + k];
    squares += error * error;
  }
  return squares / kFreedom;
}

bool on_straight_wall(const LaserScan& scan, const std::vector<ExpectedBeam>& expected,
                      std::size_t i) {
  const double r = scan.ranges[i];
  return std::isfinite(r) && r > scan.range_min && r < scan.range_max && expected[i].straight &&
         std::abs(r - expected[i].range) < kNearWall;
}

/// For maps with sparse walls: true if the beam returned something near the one before.
bool on_any_wall(const LaserScan& scan, const std::vector<ExpectedBeam>&, std::size_t i) {
  const double r = scan.ranges[i];
  const bool measured = std::isfinite(r) && r > scan.range_min && r < scan.range_max;
  return measured && (i == 0 || std::abs(r - scan.ranges[i - 1]) < kNearWall);
}

struct Samples {
  std::vector<Group> groups;
  std::vector<Residual> residuals;
};

using BeamTest = bool (*)(const LaserScan&, const std::vector<ExpectedBeam>&, std::size_t);

/// Groups of successive beams that pass `is_on_wall`; residuals of those where the map has a wall.
Samples take_samples(const AlignedLog& log, BeamTest is_on_wall) {
  Samples samples;
  for (const std::size_t index : spread_scans(log, kNoiseScans)) {
    const LaserScan& scan = log.scans[index].scan;
    const std::vector<ExpectedBeam> expected =
        expect_scan(log, log.scans[index], std::min(scan.range_max, 40.0));
    if (expected.empty()) continue;
    std::size_t run = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      run = is_on_wall(scan, expected, i) ? run + 1 : 0;
      if (run < kBeams) continue;
      const std::size_t first = i + 1 - kBeams;
      const std::size_t middle = first + kBeams / 2;
      samples.groups.push_back({scan.ranges[middle], variance_about_line(scan, first), index});
      const double residual = scan.ranges[middle] - expected[middle].range;
      if (expected[middle].wall && std::abs(residual) < kNearWall) {
        samples.residuals.push_back({residual, index});
      }
      run = 0;
    }
  }
  return samples;
}

/// Standard deviation of a bin's groups, without the rounding to `resolution`. [m]
double sigma_of(std::vector<double> variances, double resolution) {
  static const double kChi =
      boost::math::quantile(boost::math::chi_squared(kFreedom), kGroupQuantile) / kFreedom;
  std::sort(variances.begin(), variances.end());
  const double variance = percentile(variances, kGroupQuantile) / kChi;
  return std::sqrt(std::max(variance - resolution * resolution / 12.0, 0.0));
}

/// A line through the standard deviations of the bins.
struct NoiseLine {
  double at_zero = 0.0;
  double slope = 0.0;
  std::vector<RangeNoiseFit::Bin> bins;
};

/// Weighted least squares; neither value is negative.
void fit_line(NoiseLine& line, const std::vector<double>& weights) {
  double w = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  for (std::size_t i = 0; i < line.bins.size(); ++i) {
    const auto& bin = line.bins[i];
    w += weights[i];
    x += weights[i] * bin.range_m;
    y += weights[i] * bin.sigma_m;
    xx += weights[i] * bin.range_m * bin.range_m;
    xy += weights[i] * bin.range_m * bin.sigma_m;
  }
  if (!(w > 0.0)) return;
  const double determinant = w * xx - x * x;
  line.slope = determinant > 1e-9 * w * xx ? std::max((w * xy - x * y) / determinant, 0.0) : 0.0;
  line.at_zero = (y - line.slope * x) / w;
  if (line.at_zero >= 0.0) return;
  line.at_zero = 0.0;
  line.slope = xy / xx;
}

NoiseLine fit_groups(const std::vector<Group>& groups, const Blocks& blocks, std::size_t left_out,
                     double resolution) {
  std::vector<Group> kept;
  std::copy_if(groups.begin(), groups.end(), std::back_inserter(kept),
               [&](const Group& g) { return blocks.keeps(g.scan, left_out); });
  std::stable_sort(kept.begin(), kept.end(),
                   [](const Group& a, const Group& b) { return a.range_m < b.range_m; });
  NoiseLine line;
  std::vector<double> weights;
  const std::size_t each = std::max(kept.size() / kNoiseBins, kFewestInBin);
  for (std::size_t from = 0; from + each <= kept.size(); from += each) {
    std::vector<double> variances;
    double range = 0.0;
    for (std::size_t i = from; i < from + each; ++i) {
      variances.push_back(kept[i].variance);
      range += kept[i].range_m / static_cast<double>(each);
    }
    const double sigma = sigma_of(std::move(variances), resolution);
    line.bins.push_back({range, sigma});
    weights.push_back(1.0 / std::max(sigma * sigma, 1e-8));
  }
  fit_line(line, weights);
  return line;
}

double median_residual(const std::vector<Residual>& residuals, const Blocks& blocks,
                       std::size_t left_out) {
  std::vector<double> kept;
  for (const Residual& r : residuals) {
    if (blocks.keeps(r.scan, left_out)) kept.push_back(r.value);
  }
  std::sort(kept.begin(), kept.end());
  return kept.empty() ? 0.0 : percentile(kept, 0.5);
}

}  // namespace

std::optional<RangeNoiseFit> fit_range_noise(const AlignedLog& log) {
  constexpr std::size_t kFewestGroups = 200;
  Samples samples = take_samples(log, &on_straight_wall);
  if (samples.groups.size() < kFewestGroups) samples = take_samples(log, &on_any_wall);
  if (samples.groups.size() < kFewestGroups || samples.residuals.empty()) return std::nullopt;
  const Blocks blocks(log.scans.size());
  RangeNoiseFit fit;
  fit.groups = samples.groups.size();
  fit.resolution_m = find_resolution(log);
  std::vector<double> ranges;
  for (const Group& g : samples.groups) ranges.push_back(g.range_m);
  std::sort(ranges.begin(), ranges.end());
  fit.typical_range_m = percentile(ranges, 0.5);
  const auto by_blocks = [&](std::size_t left_out) {
    const NoiseLine line = fit_groups(samples.groups, blocks, left_out, fit.resolution_m);
    return std::vector{line.at_zero, line.slope, line.at_zero + line.slope * fit.typical_range_m,
                       median_residual(samples.residuals, blocks, left_out)};
  };
  const std::vector<Figure> figures = jackknife(by_blocks);
  constexpr double kModel = 0.015;  // Relative; walls are not quite straight.
  fit.sigma_m = widen(figures[0], kModel * figures[2].value);
  fit.sigma_relative = widen(figures[1], kModel * figures[2].value / fit.typical_range_m);
  fit.sigma_typical = widen(figures[2], kModel * figures[2].value);
  fit.bias_m = figures[3];
  fit.bins = fit_groups(samples.groups, blocks, Blocks::kCount, fit.resolution_m).bins;
  return fit;
}

}  // namespace castaway::testbed
