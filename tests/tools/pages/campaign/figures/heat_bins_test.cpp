#include "tools/pages/campaign/figures/campaign_figures.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/campaign_rows.hpp"

namespace castaway::testbed {
namespace {

ScoredKidnap scored(const SE2& to, std::optional<double> time_s) {
  return {kidnap_of("a", 1.0, time_s, to), 0, time_s.value_or(9.0)};
}

TEST(HeatBins, AreSquaresOfTheMap) {
  EXPECT_EQ(bin_of(0.0, 0.999), (BinNumber{0, 0}));
  EXPECT_EQ(bin_of(1.0, -0.001), (BinNumber{1, -1}));
  EXPECT_EQ(bin_of(-1.0, 12.5), (BinNumber{-1, 12}));
}

TEST(HeatBins, RoundAsTheTableDoes) {
  EXPECT_EQ(bin_of(0.9999997, 0.0), (BinNumber{1, 0}));  // kidnaps.csv: 1.000000
  EXPECT_EQ(bin_of(0.9999994, 0.0), (BinNumber{0, 0}));  // kidnaps.csv: 0.999999
}

TEST(HeatBins, CountKidnapsFailuresAndTimes) {
  HeatMap heat(2);
  heat.add("lab", 1, scored({0.5, 0.5, 0.0}, 2.0));
  heat.add("lab", 1, scored({0.9, 0.1, 1.0}, std::nullopt));
  heat.add("lab", 1, scored({0.2, 0.2, 1.0}, 1.0));
  heat.add("lab", 1, scored({1.2, 0.2, 1.0}, std::nullopt));
  ASSERT_EQ(heat.worlds(), std::vector<std::string>{"lab"});
  EXPECT_TRUE(heat.bins("lab", 0).empty());
  const HeatBins& bins = heat.bins("lab", 1);
  ASSERT_EQ(bins.size(), 2U);
  const HeatBin& first = bins.at({0, 0});
  EXPECT_EQ(first.kidnaps, 3);
  EXPECT_EQ(first.failures, 1);
  EXPECT_DOUBLE_EQ(first.failure_share(), 1.0 / 3.0);
  EXPECT_EQ(*first.median_s(), 2.0);
  EXPECT_FALSE(bins.at({1, 0}).median_s());
}

TEST(HeatBins, CountsKidnapsWithoutTarget) {
  HeatMap heat(1);
  heat.add("lab", 0, {kidnap_of("a", 1.0, 1.0, std::nullopt), 0, 1.0});
  EXPECT_TRUE(heat.worlds().empty());
  EXPECT_EQ(heat.without_target(), 1);
}

}  // namespace
}  // namespace castaway::testbed
