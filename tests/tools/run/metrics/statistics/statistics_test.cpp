#include "tools/run/metrics/statistics/statistics.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

TEST(Percentile, IsLinearBetweenTheElements) {
  const std::vector<double> ascending{1.0, 2.0, 4.0, 8.0, 16.0};
  EXPECT_DOUBLE_EQ(percentile(ascending, 0.0), 1.0);
  EXPECT_DOUBLE_EQ(percentile(ascending, 0.25), 2.0);
  EXPECT_DOUBLE_EQ(percentile(ascending, 0.4), 2.0 + 0.6 * 2.0);
  EXPECT_DOUBLE_EQ(percentile(ascending, 0.95), 8.0 + 0.8 * 8.0);
  EXPECT_DOUBLE_EQ(percentile(ascending, 1.0), 16.0);
}

TEST(Percentile, OfOneElementIsThatElement) {
  for (const double q : {0.0, 0.3, 1.0}) EXPECT_EQ(percentile({7.0}, q), 7.0);
}

TEST(Statistics, AreThoseOfTheSampleInAnyOrder) {
  const auto s = statistics({-4.0, 3.0, 1.0, 2.0});
  ASSERT_TRUE(s);
  EXPECT_DOUBLE_EQ(s->mean, 0.5);
  EXPECT_DOUBLE_EQ(s->median, 1.5);
  EXPECT_DOUBLE_EQ(s->p95, 2.0 + 0.85);
  EXPECT_DOUBLE_EQ(s->rmse, std::sqrt(30.0 / 4.0));
  EXPECT_DOUBLE_EQ(s->max, 3.0);
}

TEST(Statistics, OfNothingAreNothing) { EXPECT_FALSE(statistics({})); }

}  // namespace
}  // namespace castaway::testbed
