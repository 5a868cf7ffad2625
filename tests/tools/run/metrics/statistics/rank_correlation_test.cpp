#include "tools/run/metrics/statistics/rank_correlation.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

TEST(KendallTau, IsOneForTheSameOrder) {
  EXPECT_EQ(kendall_tau({1.0, 2.0, 3.0, 9.0}, {-1.0, 0.0, 0.1, 100.0}), 1.0);
  EXPECT_EQ(kendall_tau({3.0, 1.0, 2.0}, {30.0, 10.0, 20.0}), 1.0);
}

TEST(KendallTau, IsMinusOneForTheReverse) {
  EXPECT_EQ(kendall_tau({1.0, 2.0, 3.0}, {5.0, 4.0, -3.0}), -1.0);
}

TEST(KendallTau, CountsPairs) {
  // Of six pairs, one is in the other order.
  EXPECT_DOUBLE_EQ(*kendall_tau({1.0, 2.0, 3.0, 4.0}, {1.0, 3.0, 2.0, 4.0}), (5.0 - 1.0) / 6.0);
}

TEST(KendallTau, CorrectsForTies) {
  // Pairs (1, 2), (1, 3), (1, 4), (2, 4), (3, 4) agree, and (2, 3) is a tie in x: 5 of 5 ordered
  // ones in x and 6 in y.
  EXPECT_DOUBLE_EQ(*kendall_tau({1.0, 2.0, 2.0, 3.0}, {1.0, 3.0, 2.0, 4.0}),
                   5.0 / std::sqrt(5.0 * 6.0));
  // (1, 2) is a tie in both, (3, 4) one in y; the other four disagree.
  EXPECT_DOUBLE_EQ(*kendall_tau({1.0, 1.0, 2.0, 3.0}, {5.0, 5.0, 4.0, 4.0}),
                   -4.0 / std::sqrt(5.0 * 4.0));
}

TEST(KendallTau, IsZeroWhereAsManyPairsDisagree) {
  // (1, 2), (1, 4) and (3, 4) agree; (1, 3), (2, 3) and (2, 4) do not.
  EXPECT_EQ(kendall_tau({1.0, 2.0, 3.0, 4.0}, {2.0, 4.0, 1.0, 3.0}), 0.0);
}

TEST(KendallTau, IsTheSameBothWays) {
  const std::vector<double> x{0.3, 0.1, 0.4, 0.1, 0.5};
  const std::vector<double> y{0.2, 0.7, 0.1, 0.8, 0.2};
  EXPECT_EQ(kendall_tau(x, y), kendall_tau(y, x));
}

TEST(KendallTau, IsNothingWhereAllAreEqual) {
  EXPECT_FALSE(kendall_tau({1.0, 1.0, 1.0}, {1.0, 2.0, 3.0}));
  EXPECT_FALSE(kendall_tau({1.0, 2.0, 3.0}, {1.0, 1.0, 1.0}));
  EXPECT_FALSE(kendall_tau({1.0}, {2.0}));
  EXPECT_FALSE(kendall_tau({}, {}));
}

TEST(KendallTau, TakesRoundingForATie) { EXPECT_FALSE(kendall_tau({0.1 + 0.2, 0.3}, {1.0, 2.0})); }

}  // namespace
}  // namespace castaway::testbed
