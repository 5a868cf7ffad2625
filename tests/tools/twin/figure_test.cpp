#include "tools/twin/fits/figure.hpp"

#include <cmath>
#include <numeric>

#include <gtest/gtest.h>
#include <boost/random/normal_distribution.hpp>

#include "localization/geometry/random.hpp"

namespace castaway::testbed {
namespace {

constexpr double kStudent11 = 2.201;  // Quantile for 95 % on both sides.

/// Mean of a sample without one block.
double mean_without(const std::vector<double>& sample, std::size_t left_out) {
  const Blocks blocks(sample.size());
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < sample.size(); ++i) {
    if (!blocks.keeps(i, left_out)) continue;
    sum += sample[i];
    count += 1.0;
  }
  return sum / count;
}

Figure mean_figure(const std::vector<double>& sample) {
  return jackknife(
             [&](std::size_t left_out) { return std::vector{mean_without(sample, left_out)}; })
      .front();
}

TEST(Blocks, AreSuccessiveItems) {
  const Blocks blocks(24);
  EXPECT_EQ(blocks.items(), 24U);
  for (std::size_t i = 0; i < 24; ++i) {
    for (std::size_t block = 0; block < Blocks::kCount; ++block) {
      EXPECT_EQ(blocks.keeps(i, block), i / 2 != block) << i << " " << block;
    }
    EXPECT_TRUE(blocks.keeps(i, Blocks::kCount));  // nothing is left out
  }
}

TEST(Blocks, AreSpreadOverFewItems) {
  const Blocks blocks(3);
  EXPECT_FALSE(blocks.keeps(0, 0));
  EXPECT_FALSE(blocks.keeps(1, 4));
  EXPECT_FALSE(blocks.keeps(2, 8));
  EXPECT_TRUE(blocks.keeps(2, 11));
}

TEST(Jackknife, OfAMeanIsItsStandardError) {
  std::vector<double> sample(12);
  std::iota(sample.begin(), sample.end(), 0.0);  // mean 5.5, variance 13
  const Figure figure = mean_figure(sample);
  const double error = std::sqrt(13.0 / 12.0);
  EXPECT_DOUBLE_EQ(figure.value, 5.5);
  EXPECT_NEAR(figure.interval.low, 5.5 - kStudent11 * error, 1e-12);
  EXPECT_NEAR(figure.interval.high, 5.5 + kStudent11 * error, 1e-12);
}

TEST(Jackknife, FitsSeveralValuesAtOnce) {
  const std::vector<Figure> figures = jackknife([](std::size_t left_out) {
    const double k = static_cast<double>(left_out);
    return std::vector{k, 7.0, -2.0 * k};
  });
  ASSERT_EQ(figures.size(), 3U);
  EXPECT_EQ(figures[0].value, 12.0);  // nothing left out
  EXPECT_EQ(figures[1].value, 7.0);
  EXPECT_EQ(figures[2].value, -24.0);
  EXPECT_NEAR(figures[1].interval.low, 7.0, 1e-12);
  EXPECT_NEAR(figures[1].interval.high, 7.0, 1e-12);
  const double width = figures[0].interval.high - figures[0].interval.low;
  EXPECT_NEAR(width, 2.0 * kStudent11 * std::sqrt(143.0 * 11.0 / 12.0), 1e-9);
  EXPECT_NEAR(figures[2].interval.high - figures[2].interval.low, 2.0 * width, 1e-9);
}

TEST(Jackknife, CoversTheTruthInNineteenOfTwentyCases) {
  localization::Rng rng = localization::substream(1, "means");
  boost::random::normal_distribution<double> normal(3.0, 2.0);
  constexpr int kTrials = 2000;
  int covered = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    std::vector<double> sample(36);
    for (double& x : sample) x = normal(rng);
    const Interval interval = mean_figure(sample).interval;
    covered += interval.low <= 3.0 && 3.0 <= interval.high ? 1 : 0;
  }
  EXPECT_NEAR(covered, 0.95 * kTrials, 4.0 * std::sqrt(0.05 * 0.95 * kTrials));
}

}  // namespace
}  // namespace castaway::testbed
