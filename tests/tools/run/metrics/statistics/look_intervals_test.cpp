#include "tools/run/metrics/statistics/look_intervals.hpp"

#include <numeric>

#include <gtest/gtest.h>
#include <boost/random/bernoulli_distribution.hpp>
#include <boost/random/normal_distribution.hpp>

#include "localization/geometry/random.hpp"

namespace castaway::testbed {
namespace {

TEST(LookIntervals, LooksAtTwiceAsManyEachTime) {
  EXPECT_EQ(look_sizes(16, 100), (std::vector<int>{16, 32, 64, 100}));
  EXPECT_EQ(look_sizes(16, 16), std::vector<int>{16});
  EXPECT_EQ(look_sizes(16, 4), std::vector<int>{4});
}

TEST(LookIntervals, OneLookIsTheUsualInterval) {
  const std::vector<double> coins{1, 1, 1, 0, 1, 1, 0, 1, 1, 1};
  const auto share = mean_interval_at_look(coins, true, 1);
  const RateInterval wilson = wilson_interval(8, 10);
  EXPECT_NEAR(share->low, wilson.low, 1e-9);
  EXPECT_NEAR(share->high, wilson.high, 1e-9);
  // numpy and scipy: t.ppf(0.975, 9) * std(ddof=1) / sqrt(10) of 1..10.
  std::vector<double> numbers(10);
  std::iota(numbers.begin(), numbers.end(), 1.0);
  const auto mean = mean_interval_at_look(numbers, false, 1);
  EXPECT_NEAR(mean->low, 5.5 - 2.16585, 1e-5);
  EXPECT_NEAR(mean->high, 5.5 + 2.16585, 1e-5);
}

TEST(LookIntervals, MoreLooksAreWider) {
  const std::vector<double> coins{1, 0, 1, 1};
  const auto one = mean_interval_at_look(coins, true, 1);
  const auto six = mean_interval_at_look(coins, true, 6);
  EXPECT_LT(six->low, one->low);
  EXPECT_GT(six->high, one->high);
}

TEST(LookIntervals, SayNothingOfTooFewValues) {
  EXPECT_FALSE(mean_interval_at_look({}, true, 3));
  EXPECT_FALSE(mean_interval_at_look({1.0, 2.0}, false, 3));
  EXPECT_FALSE(mean_interval_at_look(std::vector<double>(50, 2.0), false, 3));
  EXPECT_GT(mean_interval_at_look({1.0, 1.0}, true, 3)->high - 0.5, 0.0);
}

/// Share of samples, each looked at until its interval is narrow, whose last interval misses
/// `mean`. `draw` draws a value.
template <typename Draw>
double missed(double mean, double width, bool shares, const Draw& draw) {
  constexpr int kRepeats = 2000;
  const std::vector<int> sizes = look_sizes(16, 512);
  int misses = 0;
  for (int repeat = 0; repeat < kRepeats; ++repeat) {
    std::vector<double> values;
    std::optional<Interval> interval;
    for (const int size : sizes) {
      while (static_cast<int>(values.size()) < size) values.push_back(draw());
      interval = mean_interval_at_look(values, shares, static_cast<int>(sizes.size()));
      if (interval && interval->high - interval->low <= width) break;
    }
    misses += interval->low > mean || interval->high < mean ? 1 : 0;
  }
  return static_cast<double>(misses) / kRepeats;
}

TEST(LookIntervals, HoldTheMeanWhereverTheSampleStops) {
  localization::Rng rng = localization::substream(1, "looks");
  for (const double p : {0.02, 0.5, 0.9}) {
    boost::random::bernoulli_distribution<double> coin(p);
    EXPECT_LT(missed(p, 0.15, true, [&] { return coin(rng) ? 1.0 : 0.0; }), 0.05) << p;
  }
  boost::random::normal_distribution<double> normal(3.0, 1.0);
  EXPECT_LT(missed(3.0, 0.4, false, [&] { return normal(rng); }), 0.05);
}

}  // namespace
}  // namespace castaway::testbed
