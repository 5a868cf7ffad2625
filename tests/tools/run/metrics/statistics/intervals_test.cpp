#include "tools/run/metrics/statistics/intervals.hpp"

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

TEST(WilsonInterval, OfAllSuccessesHasTheClosedForm) {
  // p = 1: low = n / (n + z^2), high = 1
  const RateInterval interval = wilson_interval(30, 30);
  EXPECT_NEAR(interval.low, 30.0 / (30.0 + 1.959963984540054 * 1.959963984540054), 1e-12);
  EXPECT_NEAR(interval.low, 0.886, 0.0005);
  EXPECT_DOUBLE_EQ(interval.high, 1.0);
}

TEST(WilsonInterval, OfNoSuccessIsItsMirrorImage) {
  const RateInterval none = wilson_interval(0, 30);
  EXPECT_EQ(none.low, 0.0);
  EXPECT_NEAR(none.high, 1.0 - wilson_interval(30, 30).low, 1e-12);
}

TEST(WilsonInterval, OfHalfIsSymmetric) {
  // p = 1/2: half width = z / (2 sqrt(n + z^2))
  const RateInterval interval = wilson_interval(5, 10);
  EXPECT_NEAR(interval.low, 0.236593, 1e-6);
  EXPECT_NEAR(interval.high, 0.763407, 1e-6);
}

TEST(WilsonInterval, WithoutTrialsSaysNothing) {
  EXPECT_EQ(wilson_interval(0, 0).low, 0.0);
  EXPECT_EQ(wilson_interval(0, 0).high, 1.0);
}

}  // namespace
}  // namespace castaway::testbed
