#include "tools/run/metrics/statistics/paired_shares.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

TEST(PairedShares, CountsTheFourOutcomes) {
  PairedOutcomes outcomes;
  outcomes.add(true, true);
  outcomes.add(true, false);
  outcomes.add(true, false);
  outcomes.add(false, true);
  outcomes.add(false, false);
  EXPECT_EQ(outcomes.both, 1);
  EXPECT_EQ(outcomes.only_first, 2);
  EXPECT_EQ(outcomes.only_second, 1);
  EXPECT_EQ(outcomes.neither, 1);
  EXPECT_DOUBLE_EQ(outcomes.difference(), 0.2);
}

TEST(PairedShares, McNemarIsATossOfCoins) {
  EXPECT_EQ(mcnemar_p_value({7, 0, 0, 3}), 1.0);
  EXPECT_EQ(mcnemar_p_value({0, 1, 1, 0}), 1.0);
  EXPECT_DOUBLE_EQ(mcnemar_p_value({4, 0, 5, 1}), 2.0 / 32.0);
  EXPECT_DOUBLE_EQ(mcnemar_p_value({4, 5, 0, 1}), 2.0 / 32.0);
}

// By the sum of binomial coefficients.
TEST(PairedShares, McNemarAgreesWithTheSum) {
  for (int first = 0; first < 9; ++first) {
    for (int second = 0; second < 9; ++second) {
      const int n = first + second;
      double sum = 0.0;
      double coefficient = 1.0;
      for (int k = 0; k <= std::min(first, second); ++k) {
        sum += coefficient;
        coefficient *= static_cast<double>(n - k) / (k + 1);
      }
      const double expected = std::min(1.0, 2.0 * sum / std::pow(2.0, n));
      EXPECT_NEAR(mcnemar_p_value({3, first, second, 2}), n == 0 ? 1.0 : expected, 1e-12);
    }
  }
}

TEST(PairedShares, TheIntervalIsWaldsWithTwoMoreTrials) {
  const Interval interval = paired_difference_interval({10, 6, 2, 2});
  const double difference = 4.0 / 22.0;
  const double half = 1.959963984540054 * std::sqrt((9.0 / 22.0 - difference * difference) / 22.0);
  EXPECT_NEAR(interval.low, difference - half, 1e-12);
  EXPECT_NEAR(interval.high, difference + half, 1e-12);
}

TEST(PairedShares, WithoutTrialsTheIntervalIsWide) {
  const Interval interval = paired_difference_interval({});
  EXPECT_EQ(interval.low, -interval.high);
  EXPECT_GT(interval.high, 0.9);
}

}  // namespace
}  // namespace castaway::testbed
