#include "tools/run/metrics/statistics/bootstrap.hpp"

#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

std::vector<double> counting(int count) {
  std::vector<double> sample(static_cast<std::size_t>(count));
  std::iota(sample.begin(), sample.end(), 0.0);
  return sample;
}

TEST(Bootstrap, OfEqualElementsIsThatElement) {
  const auto intervals = bootstrap({3.0, 3.0, 3.0}, {.stream = "test"});
  ASSERT_TRUE(intervals);
  EXPECT_EQ(intervals->mean.low, 3.0);
  EXPECT_EQ(intervals->mean.high, 3.0);
  EXPECT_EQ(intervals->median.low, 3.0);
  EXPECT_EQ(intervals->median.high, 3.0);
}

TEST(Bootstrap, OfALargeSampleIsTheNormalInterval) {
  const std::vector<double> sample = counting(1000);
  const auto intervals = bootstrap(sample, {.stream = "test", .resamples = 2000});
  const double sigma = 1000.0 / std::sqrt(12.0) / std::sqrt(1000.0);  // of the mean
  EXPECT_NEAR(intervals->mean.low, 499.5 - 1.96 * sigma, 0.2 * sigma);
  EXPECT_NEAR(intervals->mean.high, 499.5 + 1.96 * sigma, 0.2 * sigma);
  const double median_sigma = 1000.0 / (2.0 * std::sqrt(1000.0));
  EXPECT_NEAR(intervals->median.low, 499.5 - 1.96 * median_sigma, 0.25 * median_sigma);
  EXPECT_NEAR(intervals->median.high, 499.5 + 1.96 * median_sigma, 0.25 * median_sigma);
}

TEST(Bootstrap, BlocksMakeTheIntervalOfASlowSignalAsWideAsItIs) {
  std::vector<double> slow;  // a hundred values, each repeated ten times: a tenth of the
                             // information
  for (int i = 0; i < 1000; ++i) slow.push_back((i / 10 * 37) % 100);
  const auto single = bootstrap(slow, {.stream = "test"});
  const auto blocks = bootstrap(slow, {.stream = "test", .block = 10});
  const double narrow = single->mean.high - single->mean.low;
  const double wide = blocks->mean.high - blocks->mean.low;
  EXPECT_NEAR(wide / narrow, std::sqrt(10.0) * std::sqrt(0.7), 0.5);  // blocks start anywhere
}

TEST(Bootstrap, IsTheSameAgainAndDiffersByStream) {
  const std::vector<double> sample = counting(20);
  const auto once = bootstrap(sample, {.stream = "a"});
  const auto again = bootstrap(sample, {.stream = "a"});
  const auto other = bootstrap(sample, {.stream = "b"});
  EXPECT_EQ(once->mean.low, again->mean.low);
  EXPECT_EQ(once->median.high, again->median.high);
  EXPECT_NE(once->mean.low, other->mean.low);
}

TEST(Bootstrap, OfTooFewIsNothing) {
  EXPECT_FALSE(bootstrap({}, {.stream = "test"}));
  EXPECT_FALSE(bootstrap({1.0}, {.stream = "test"}));
  EXPECT_FALSE(bootstrap(counting(9), {.stream = "test", .block = 5}));
  EXPECT_TRUE(bootstrap(counting(10), {.stream = "test", .block = 5}));
}

TEST(StatisticsWithIntervals, HaveBothOrTheFiguresAlone) {
  const auto two = statistics_with_intervals({1.0, 3.0}, {.stream = "test"});
  EXPECT_EQ(two->mean, 2.0);
  ASSERT_TRUE(two->mean_interval);
  EXPECT_EQ(two->mean_interval->low, 1.0);
  EXPECT_EQ(two->mean_interval->high, 3.0);
  const auto one = statistics_with_intervals({1.0}, {.stream = "test"});
  EXPECT_EQ(one->mean, 1.0);
  EXPECT_FALSE(one->mean_interval);
  EXPECT_FALSE(statistics_with_intervals({}, {.stream = "test"}));
}

}  // namespace
}  // namespace castaway::testbed
