#include "tools/scenario/sample_design.hpp"

#include <cmath>
#include <set>

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

TEST(SampleDesign, IndependentHasOneSampleForEachSeed) {
  const SampleDesign design(Design::kIndependent, 1, 7, {"a"});
  EXPECT_EQ(design.samples(), 7);
  EXPECT_EQ(design.seed_offset(6), 6);
}

TEST(SampleDesign, LatinHypercubeHasOneValueInEachStratum) {
  constexpr int kSeeds = 40;
  const SampleDesign design(Design::kLatinHypercube, 3, kSeeds, {"a", "b"});
  EXPECT_EQ(design.samples(), kSeeds);
  int equal = 0;
  for (const std::size_t key : {0U, 1U}) {
    std::set<int> strata;
    for (int i = 0; i < kSeeds; ++i) {
      strata.insert(static_cast<int>(kSeeds * design.quantile(i, key)));
    }
    EXPECT_EQ(strata.size(), 40U);
    EXPECT_EQ(*strata.begin(), 0);
    EXPECT_EQ(*strata.rbegin(), kSeeds - 1);
  }
  for (int i = 0; i < kSeeds; ++i) {
    equal += static_cast<int>(kSeeds * design.quantile(i, 0)) ==
                     static_cast<int>(kSeeds * design.quantile(i, 1))
                 ? 1
                 : 0;
  }
  EXPECT_LT(equal, 8);  // Of two random orders, 1 on average.
}

TEST(SampleDesign, SobolFillsTheSquareMoreEvenlyThanChance) {
  constexpr int kSeeds = 256;
  const SampleDesign design(Design::kSobol, 1, kSeeds, {"a", "b"});
  std::vector<int> counts(64, 0);
  for (int i = 0; i < kSeeds; ++i) {
    const auto column = static_cast<std::size_t>(8.0 * design.quantile(i, 0));
    const auto row = static_cast<std::size_t>(8.0 * design.quantile(i, 1));
    ++counts[8 * row + column];
  }
  double squares = 0.0;
  for (const int count : counts) squares += (count - 4.0) * (count - 4.0);
  EXPECT_LT(squares / 64.0, 2.0);  // Independent points: 4.
}

TEST(SampleDesign, FollowsFromRootAndKeys) {
  for (const Design kind : {Design::kLatinHypercube, Design::kSobol, Design::kSaltelli}) {
    const SampleDesign design(kind, 1, 8, {"a", "b"});
    EXPECT_EQ(design.quantile(5, 1), SampleDesign(kind, 1, 8, {"a", "b"}).quantile(5, 1));
    EXPECT_NE(design.quantile(5, 1), SampleDesign(kind, 2, 8, {"a", "b"}).quantile(5, 1));
    EXPECT_GE(design.quantile(5, 1), 0.0);
    EXPECT_LT(design.quantile(5, 1), 1.0);
  }
}

// Blocks of 4 seeds: two samples, the first with "a", "b" and the seed of the second.
TEST(SampleDesign, SaltelliTakesOneKeyAfterTheOtherFromTheSecondSample) {
  const SampleDesign design(Design::kSaltelli, 1, 4, {"a", "b"});
  ASSERT_EQ(design.samples(), 20);
  for (int i = 0; i < 4; ++i) {
    const double a[] = {design.quantile(i, 0), design.quantile(4 + i, 0)};
    const double b[] = {design.quantile(i, 1), design.quantile(4 + i, 1)};
    EXPECT_NE(a[0], a[1]);
    EXPECT_EQ(design.seed_offset(i), i);
    EXPECT_EQ(design.seed_offset(4 + i), 4 + i);
    EXPECT_EQ(design.quantile(8 + i, 0), a[1]);
    EXPECT_EQ(design.quantile(8 + i, 1), b[0]);
    EXPECT_EQ(design.seed_offset(8 + i), i);
    EXPECT_EQ(design.quantile(12 + i, 0), a[0]);
    EXPECT_EQ(design.quantile(12 + i, 1), b[1]);
    EXPECT_EQ(design.quantile(16 + i, 0), a[0]);
    EXPECT_EQ(design.quantile(16 + i, 1), b[0]);
    EXPECT_EQ(design.seed_offset(16 + i), 4 + i);
  }
}

}  // namespace
}  // namespace castaway::testbed
