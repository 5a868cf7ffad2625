#include "tools/twin/fits/stamp_fit.hpp"

#include <cmath>

#include <gtest/gtest.h>
#include <boost/random/normal_distribution.hpp>

#include "localization/geometry/random.hpp"

namespace castaway::testbed {
namespace {

/// Stamps after 1000 s with these periods. [s]
std::vector<Stamp> stamps_with(const std::vector<double>& periods) {
  std::vector<Stamp> stamps = {std::chrono::seconds(1000)};
  for (const double period : periods) {
    stamps.push_back(stamps.back() + localization::from_seconds(period));
  }
  return stamps;
}

TEST(StampFit, OfARegularLidarIsItsRate) {
  const StampFit fit = fit_stamps(stamps_with({0.1, 0.1, 0.1, 0.1}));
  EXPECT_NEAR(fit.rate_hz, 10.0, 1e-9);
  EXPECT_NEAR(fit.jitter_s, 0.0, 1e-12);
  EXPECT_EQ(fit.gap_share, 0.0);
  EXPECT_NEAR(fit.longest_s, 0.1, 1e-12);
}

TEST(StampFit, TakesJitterFromTheQuartiles) {
  const StampFit fit = fit_stamps(stamps_with({0.12, 0.08, 0.10, 0.11, 0.09}));
  EXPECT_NEAR(fit.rate_hz, 10.0, 1e-9);
  EXPECT_NEAR(fit.jitter_s, 0.7413 * (0.11 - 0.09), 1e-9);
  EXPECT_EQ(fit.gap_share, 0.0);
  EXPECT_NEAR(fit.longest_s, 0.12, 1e-12);
}

TEST(StampFit, CountsGapsAndKeepsThemOutOfTheJitter) {
  const StampFit fit = fit_stamps(stamps_with({0.2, 0.2, 0.31, 0.2, 0.2, 0.2, 5.0, 0.2, 0.2, 0.2}));
  EXPECT_NEAR(fit.rate_hz, 5.0, 1e-9);
  EXPECT_NEAR(fit.jitter_s, 0.0, 1e-12);
  EXPECT_NEAR(fit.gap_share, 0.2, 1e-12);
  EXPECT_NEAR(fit.longest_s, 5.0, 1e-9);
  EXPECT_EQ(fit_stamps(stamps_with({0.2, 0.29, 0.2})).gap_share, 0.0);  // shorter than a gap
}

TEST(StampFit, OfTwoScansIsTheirPeriod) {
  EXPECT_NEAR(fit_stamps(stamps_with({0.25})).rate_hz, 4.0, 1e-9);
  const StampFit same = fit_stamps(stamps_with({0.0}));
  EXPECT_EQ(same.rate_hz, 0.0);
  EXPECT_EQ(same.jitter_s, 0.0);
  EXPECT_EQ(same.gap_share, 0.0);
}

TEST(StampFit, FindsNormalJitterDespiteGaps) {
  localization::Rng rng = localization::substream(1, "periods");
  constexpr double kSigma = 0.004;
  constexpr int kPeriods = 4000;
  boost::random::normal_distribution<double> normal(0.1, kSigma);
  std::vector<double> periods;
  for (int k = 0; k < kPeriods; ++k) periods.push_back(k % 100 == 99 ? 0.5 : normal(rng));
  const StampFit fit = fit_stamps(stamps_with(periods));
  const double error = kSigma / std::sqrt(kPeriods);
  EXPECT_NEAR(1.0 / fit.rate_hz, 0.1, 4.0 * 1.25 * error);  // of a median
  EXPECT_NEAR(fit.jitter_s, kSigma, 4.0 * 1.17 * error);    // of the quartiles' distance
  EXPECT_NEAR(fit.gap_share, 0.01, 1e-12);
}

}  // namespace
}  // namespace castaway::testbed
