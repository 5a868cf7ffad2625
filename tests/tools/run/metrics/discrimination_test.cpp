#include "tools/run/metrics/discrimination.hpp"

#include <random>

#include <gtest/gtest.h>

#include "tests/tools/support/metric_rows.hpp"

namespace castaway::testbed {
namespace {

/// Computes the area by its definition, over all pairs.
double naive_area(const std::vector<ScoredOutput>& outputs) {
  double wins = 0.0;
  double pairs = 0.0;
  for (const ScoredOutput& right : outputs) {
    for (const ScoredOutput& wrong : outputs) {
      if (!right.right || wrong.right) continue;
      pairs += 1.0;
      if (right.score > wrong.score) wins += 1.0;
      if (right.score == wrong.score) wins += 0.5;
    }
  }
  return wins / pairs;
}

TEST(RocArea, IsOneForPerfectZeroForInvertedAndAHalfForBlindScores) {
  EXPECT_EQ(roc_area({{0.9, true}, {0.8, true}, {0.1, false}}), 1.0);
  EXPECT_EQ(roc_area({{0.1, true}, {0.2, false}}), 0.0);
  EXPECT_EQ(roc_area({{0.5, true}, {0.5, false}, {0.5, true}}), 0.5);
}

TEST(RocArea, EqualsThePairByPairDefinitionWithTies) {
  std::mt19937_64 rng(3);
  std::vector<ScoredOutput> outputs;
  for (int i = 0; i < 200; ++i) {
    const bool right = rng() % 3 != 0;
    outputs.push_back({static_cast<double>(rng() % 12) + (right ? 2.0 : 0.0), right});
  }
  EXPECT_NEAR(*roc_area(outputs), naive_area(outputs), 1e-12);
}

TEST(RocArea, NeedsBothKinds) {
  EXPECT_FALSE(roc_area({}));
  EXPECT_FALSE(roc_area({{1.0, true}}));
  EXPECT_FALSE(roc_area({{1.0, false}}));
}

TEST(RocCurve, GoesFromTheOriginToBothWhole) {
  const auto curve = roc_curve({{3.0, true}, {2.0, false}, {2.0, true}, {1.0, false}});
  const std::vector<std::pair<double, double>> expected{
      {0.0, 0.0}, {0.0, 0.5}, {0.5, 1.0}, {1.0, 1.0}};
  EXPECT_EQ(curve, expected);
}

TEST(Correlation, IsThatOfPearson) {
  EXPECT_NEAR(*correlation({{1.0, 2.0}, {2.0, 4.0}, {3.0, 6.0}}), 1.0, 1e-12);
  EXPECT_NEAR(*correlation({{1.0, 1.0}, {2.0, -1.0}}), -1.0, 1e-12);
  EXPECT_NEAR(*correlation({{1.0, 0.0}, {2.0, 1.0}, {3.0, 0.0}}), 0.0, 1e-12);
  EXPECT_FALSE(correlation({{1.0, 1.0}, {1.0, 2.0}}));
  EXPECT_FALSE(correlation({}));
}

TEST(Discrimination, ScoresTheRowsThatCanBeJudged) {
  std::vector<MetricRow> rows = rows_with({0.1, 0.5, 0.2, 3.0});
  rows[0].quality = 0.9;
  rows[1].quality = 0.4;  // 0.5 m is wrong
  rows[2].quality = 0.3;
  rows[3].T_map_base_true.reset();
  for (std::size_t i = 0; i < 3; ++i) rows[i].probability = 0.5;
  rows[0].sigma_m = rows[2].sigma_m = 0.01;
  rows[1].sigma_m = 0.3;
  const Discrimination result = discrimination_of(rows);
  EXPECT_EQ(result.right, 2);
  EXPECT_EQ(result.wrong, 1);
  EXPECT_EQ(result.quality, 0.5);
  EXPECT_EQ(result.probability, 0.5);
  EXPECT_EQ(result.covariance, 1.0);
}

}  // namespace
}  // namespace castaway::testbed
