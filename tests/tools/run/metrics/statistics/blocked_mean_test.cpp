#include "tools/run/metrics/statistics/blocked_mean.hpp"

#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "localization/geometry/random.hpp"

namespace castaway::testbed {
namespace {

/// Every value is a block.
BlockedMean mean_of(const std::vector<double>& values) {
  BlockedMean mean;
  for (std::size_t i = 0; i < values.size(); ++i) mean.add(values[i], i);
  return mean;
}

/// Every list is a block.
BlockedMean mean_of(const std::vector<std::vector<double>>& blocks) {
  BlockedMean mean;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    for (const double value : blocks[b]) mean.add(value, 100 - b);
  }
  return mean;
}

double uniform(localization::Rng& rng) {
  return static_cast<double>(rng() >> 11U) / static_cast<double>(1ULL << 53U);
}

TEST(BlockedMean, OfTwoValuesHasTheClosedForm) {
  const BlockedMean mean = mean_of(std::vector<double>{1.0, 3.0});
  EXPECT_EQ(mean.mean(), 2.0);
  EXPECT_EQ(mean.blocks(), 2);
  // One degree of freedom: the quantile of Cauchy's distribution, tan(0.475 pi).
  const double half = std::tan(0.475 * std::acos(-1.0));
  EXPECT_NEAR(mean.interval()->low, 2.0 - half, 1e-9);
  EXPECT_NEAR(mean.interval()->high, 2.0 + half, 1e-9);
}

TEST(BlockedMean, OfOneBlockHasNoInterval) {
  const BlockedMean mean = mean_of(std::vector<std::vector<double>>{{1.0, 5.0, 6.0}});
  EXPECT_EQ(mean.mean(), 4.0);
  EXPECT_EQ(mean.count(), 3);
  EXPECT_FALSE(mean.interval());
  EXPECT_EQ(mean.p_value(), 1.0);
  EXPECT_FALSE(BlockedMean().interval());
}

TEST(BlockedMean, OfEqualValuesIsSure) {
  EXPECT_EQ(mean_of(std::vector<double>{0.0, 0.0}).p_value(), 1.0);
  EXPECT_EQ(mean_of(std::vector<double>{2.1, 2.1, 2.1}).p_value(), 0.0);
  EXPECT_EQ(mean_of(std::vector<double>{2.1, 2.1, 2.1}).interval()->low, 2.1);
}

// A value that is repeated within its block says nothing new.
TEST(BlockedMean, RepeatedValuesDoNotNarrowTheInterval) {
  const BlockedMean once = mean_of(std::vector<double>{1.0, 2.0, 4.0});
  const BlockedMean twice =
      mean_of(std::vector<std::vector<double>>{{1.0, 1.0}, {2.0, 2.0}, {4.0, 4.0}});
  EXPECT_NEAR(twice.interval()->low, once.interval()->low, 1e-12);
  EXPECT_NEAR(twice.p_value(), once.p_value(), 1e-12);
}

// scipy.stats.t.interval and ttest_1samp.
TEST(BlockedMean, AgreesWithScipy) {
  const BlockedMean mean = mean_of(std::vector<double>{2.0, 3.5, 1.0, 4.0, 7.5});
  EXPECT_NEAR(mean.interval()->low, 0.514521177129, 1e-9);
  EXPECT_NEAR(mean.interval()->high, 6.685478822871, 1e-9);
  EXPECT_NEAR(mean.p_value(), 0.031690966885, 1e-9);
}

// By the definition, with two passes.
TEST(BlockedMean, AgreesWithTheDefinitionForUnequalBlocks) {
  const std::vector<std::vector<double>> blocks{{1.0, 2.0}, {5.0}, {0.5, 0.25, 4.0}, {2.0, 2.5}};
  const BlockedMean mean = mean_of(blocks);
  double squares = 0.0;
  for (const auto& block : blocks) {
    const double total = std::accumulate(block.begin(), block.end(), 0.0);
    squares += std::pow(total - static_cast<double>(block.size()) * mean.mean(), 2);
  }
  const double error = std::sqrt(4.0 / 3.0 * squares) / 8.0;
  EXPECT_DOUBLE_EQ(mean.mean(), 17.25 / 8.0);
  constexpr double kQuantile = 3.182446305284263;  // Student, 3 degrees of freedom, 97.5 %
  EXPECT_NEAR(mean.interval()->high - mean.mean(), kQuantile * error, 1e-9);
}

TEST(BlockedMean, IsExactForLargeValuesOfSmallSpread) {
  const BlockedMean mean =
      mean_of(std::vector<double>{1e9 + 4.0, 1e9 + 7.0, 1e9 + 13.0, 1e9 + 16.0});
  constexpr double kQuantile = 3.182446305284263;
  EXPECT_NEAR(mean.interval()->high - mean.mean(), kQuantile * std::sqrt(30.0 / 4.0), 1e-5);
}

// Of 400 intervals of 20 blocks, 95 % hold the mean: 380 with a standard deviation of 4.4. In each
// block, three values have a common part and one of their own.
TEST(BlockedMean, ItsIntervalHoldsTheMeanAsOftenAsItSays) {
  localization::Rng rng = localization::substream(1, "blocked-mean");
  int held = 0;
  for (int k = 0; k < 400; ++k) {
    BlockedMean mean;
    for (std::uint64_t block = 0; block < 20; ++block) {
      const double common = uniform(rng);
      for (int i = 0; i < 3; ++i) mean.add(common + 0.3 * (uniform(rng) - 0.5), block);
    }
    held += mean.interval()->low <= 0.5 && 0.5 <= mean.interval()->high ? 1 : 0;
  }
  EXPECT_NEAR(held, 380, 4 * 4.4);
}

}  // namespace
}  // namespace castaway::testbed
