#include "tools/twin/fits/range_noise_fit.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include <gtest/gtest.h>
#include <boost/random/normal_distribution.hpp>

#include "tests/tools/twin/room_log.hpp"

namespace castaway::testbed {
namespace {

/// Relative error of a standard deviation by the 0.35 quantile of `groups` variances with five
/// degrees of freedom: sqrt(q (1 - q)) / density / quantile / 2.
double quantile_error(double groups) { return 0.47 / std::sqrt(groups); }

/// Changes all ranges of a log.
AlignedLog change_ranges(AlignedLog log, const std::function<double(double)>& change) {
  for (AlignedScan& aligned : log.scans) {
    for (float& r : aligned.scan.ranges) r = static_cast<float>(change(r));
  }
  return log;
}

/// Exact scans with normal noise whose standard deviation grows with the range.
AlignedLog noisy_log(int scans, double sigma_m, double sigma_relative, double step = 0.0) {
  localization::Rng rng = localization::substream(1, "ranges");
  boost::random::normal_distribution<double> normal;
  return change_ranges(room_log(scans), [&](double r) {
    const double noisy = r + (sigma_m + sigma_relative * r) * normal(rng);
    return step > 0.0 ? step * std::round(noisy / step) : noisy;
  });
}

/// Standard deviations of the two parameters of a line through the bins.
struct LineErrors {
  double at_zero = 0.0;
  double slope = 0.0;
};

LineErrors line_errors(const RangeNoiseFit& fit) {
  double w = 0.0;
  double x = 0.0;
  double xx = 0.0;
  const double in_bin = static_cast<double>(fit.groups) / static_cast<double>(fit.bins.size());
  for (const RangeNoiseFit::Bin& bin : fit.bins) {
    const double weight = std::pow(quantile_error(in_bin) * bin.sigma_m, -2.0);
    w += weight;
    x += weight * bin.range_m;
    xx += weight * bin.range_m * bin.range_m;
  }
  const double determinant = w * xx - x * x;
  return {std::sqrt(xx / determinant), std::sqrt(w / determinant)};
}

TEST(RangeNoise, OfExactScansIsZero) {
  const auto fit = fit_range_noise(room_log(60));
  ASSERT_TRUE(fit);
  EXPECT_LT(fit->sigma_m.value, 1e-5);
  EXPECT_LT(fit->sigma_relative.value, 1e-5);
  EXPECT_NEAR(fit->bias_m.value, 0.0, 1e-5);
  EXPECT_EQ(fit->resolution_m, 0.0);
  EXPECT_GT(fit->groups, 60U * 360U / 7U * 3U / 4U);  // some are lost at corners
  EXPECT_LE(fit->groups, 60U * 360U / 7U);
  EXPECT_GT(fit->typical_range_m, 1.0);
  EXPECT_LT(fit->typical_range_m, 5.0);
}

TEST(RangeNoise, LeavesABiasOfEitherSignToItself) {
  for (const double bias : {0.03, -0.03}) {
    const auto fit =
        fit_range_noise(change_ranges(room_log(60), [&](double r) { return r + bias; }));
    ASSERT_TRUE(fit);
    EXPECT_NEAR(fit->bias_m.value, bias, 1e-5);
    EXPECT_LT(fit->sigma_typical.value, 2e-4);
  }
}

TEST(RangeNoise, NeedsGroups) {
  EXPECT_FALSE(fit_range_noise(room_log(2)));  // about 90 groups
  EXPECT_FALSE(fit_range_noise(pillars_log(60)));
  EXPECT_FALSE(fit_range_noise(change_ranges(room_log(60), [](double r) { return r + 0.3; })));
  EXPECT_FALSE(fit_range_noise(change_ranges(room_log(60), [](double) { return 12.0; })));
}

TEST(RangeNoise, TakesNeighbouringRangesWhereTheMapHasNoStraightWalls) {
  AlignedLog log = noisy_log(60, 0.012, 0.0);
  const auto on_straight = fit_range_noise(log);
  // Teeth of 0.1 m on all walls of the map.
  for (double at = 0.2; at < 7.8; at += 0.2) {
    for (const double wall : {0.2, 5.7}) {
      test::fill(log.grid, at, wall, at + 0.1, wall + 0.1, localization::CellState::kOccupied);
    }
    for (const double wall : {0.2, 7.7}) {
      test::fill(log.grid, wall, at, wall + 0.1, at + 0.1, localization::CellState::kOccupied);
    }
  }
  const auto fit = fit_range_noise(log);
  ASSERT_TRUE(fit && on_straight);
  EXPECT_GT(fit->groups, on_straight->groups);  // there are more: they need no wall of the map
  const double error = quantile_error(static_cast<double>(fit->groups)) * 0.012;
  EXPECT_NEAR(fit->sigma_typical.value, 0.012, 4.0 * error);
}

TEST(RangeNoise, IsThatOfTheRangesAtAllDistances) {
  const auto fit = fit_range_noise(noisy_log(300, 0.012, 0.0));
  ASSERT_TRUE(fit);
  const LineErrors errors = line_errors(*fit);
  EXPECT_NEAR(fit->sigma_m.value, 0.012, 4.0 * errors.at_zero);
  EXPECT_NEAR(fit->sigma_relative.value, 0.0, 4.0 * errors.slope);
  const auto groups = static_cast<double>(fit->groups);
  EXPECT_NEAR(fit->sigma_typical.value, 0.012, 4.0 * quantile_error(groups) * 0.012);
  EXPECT_NEAR(fit->bias_m.value, 0.0, 4.0 * 1.25 * 0.012 / std::sqrt(groups));  // of a median
  EXPECT_EQ(fit->bins.size(), 10U);
  EXPECT_LT(fit->sigma_typical.interval.low, fit->sigma_typical.value);
  EXPECT_GT(fit->sigma_typical.interval.high, fit->sigma_typical.value);
}

TEST(RangeNoise, GrowsWithTheRange) {
  const auto fit = fit_range_noise(noisy_log(300, 0.005, 0.004));
  ASSERT_TRUE(fit);
  const LineErrors errors = line_errors(*fit);
  EXPECT_LT(errors.slope, 2e-4);
  EXPECT_NEAR(fit->sigma_m.value, 0.005, 4.0 * errors.at_zero);
  EXPECT_NEAR(fit->sigma_relative.value, 0.004, 4.0 * errors.slope);
  EXPECT_NEAR(fit->sigma_typical.value,
              fit->sigma_m.value + fit->sigma_relative.value * fit->typical_range_m, 1e-12);
  const auto farther = [](const auto& a, const auto& b) { return a.range_m < b.range_m; };
  EXPECT_TRUE(std::is_sorted(fit->bins.begin(), fit->bins.end(), farther));
  EXPECT_LT(fit->bins.front().sigma_m, fit->bins.back().sigma_m);
}

TEST(RangeNoise, DoesNotCountTheRoundingOfRanges) {
  constexpr double kSigma = 0.008;
  const auto fit = fit_range_noise(noisy_log(300, kSigma, 0.0, 0.01));
  ASSERT_TRUE(fit);
  EXPECT_EQ(fit->resolution_m, 0.01);
  const double error = 4.0 * quantile_error(static_cast<double>(fit->groups)) * kSigma;
  EXPECT_LT(error, 0.5 * (std::sqrt(kSigma * kSigma + 1e-4 / 12.0) - kSigma));
  EXPECT_NEAR(fit->sigma_typical.value, kSigma, error);
}

TEST(RangeNoise, LeavesOutWhatStandsBeforeTheWalls) {
  AlignedLog log = noisy_log(300, 0.01, 0.0);
  for (AlignedScan& aligned : log.scans) {
    for (std::size_t i = 0; i < 120; ++i) aligned.scan.ranges[i] = 0.4F;
  }
  const auto all = fit_range_noise(noisy_log(300, 0.01, 0.0));
  const auto fit = fit_range_noise(log);
  ASSERT_TRUE(fit && all);
  EXPECT_LT(fit->groups, all->groups * 3 / 4);
  const double error = quantile_error(static_cast<double>(fit->groups)) * 0.01;
  EXPECT_NEAR(fit->sigma_typical.value, 0.01, 4.0 * error);
}

}  // namespace
}  // namespace castaway::testbed
