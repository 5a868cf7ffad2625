#include "localization/paper/quality_rules.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/localization/paper/paper_cases.hpp"

namespace castaway::localization {
namespace {

TEST(MergeByWeight, KeepsTheHeavierParticlesOfBoth) {
  std::vector<Hypothesis> all = {hypothesis_at(0, {1, 1, 0}, 0.4),
                                 hypothesis_at(1, {1.1, 1, 0}, 0.8),
                                 hypothesis_at(2, {5, 5, 0}, 0.3)};
  merge_by_weight({0.2, 0.3}, all);
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].id, 0);
  EXPECT_EQ(all[0].quality, 0.8);
  for (const SE2& pose : all[0].particles.poses) EXPECT_EQ(pose.x, 1.1);
  EXPECT_NEAR(all[0].belief.mean.x, 1.1, 1e-12);
}

TEST(DestroyByQuality, RemovesTheBadButNeverTheBest) {
  std::vector<Hypothesis> all = {hypothesis_at(0, {}, 0.1), hypothesis_at(1, {}, 0.2),
                                 hypothesis_at(2, {}, 0.05)};
  destroy_by_quality({}, all);
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].id, 1);
  std::vector<Hypothesis> none;
  destroy_by_quality({}, none);
  EXPECT_TRUE(none.empty());
}

TEST(IsApart, NeedsDistanceOrAnotherHeading) {
  const std::vector<Hypothesis> all = {hypothesis_at(0, {1, 1, 0}, 0.5)};
  EXPECT_FALSE(is_apart({}, all, {1.3, 1, 0.5}));
  EXPECT_TRUE(is_apart({}, all, {1.6, 1, 0.0}));
  EXPECT_TRUE(is_apart({}, all, {1.0, 1, 3.0}));
}

TEST(PreferByQuality, WantsAMarginOrAnOutputThatIsGone) {
  const std::vector<Hypothesis> all = {hypothesis_at(3, {}, 0.5), hypothesis_at(4, {5, 5, 0}, 0.59),
                                       hypothesis_at(5, {8, 8, 0}, 0.7)};
  EXPECT_EQ(prefer_by_quality({}, {all[0], all[1]}, 3), 3);  // better by 0.09
  EXPECT_EQ(prefer_by_quality({}, all, 3), 5);
  EXPECT_EQ(prefer_by_quality({}, {all[0], all[1]}, 9), 4);
}

TEST(HeavierHalf, CountsSharesTimesTheFactor) {
  Hypothesis a = hypothesis_at(0, {1, 0, 0}, 0.0);
  a.particles.log_weights = {std::log(0.9), std::log(0.1)};
  const Hypothesis b = hypothesis_at(1, {2, 0, 0}, 0.0);
  const ParticleSet half = heavier_half(a, 0.5, b, 1.0);  // 0.45 and 0.05, 0.5 and 0.5
  EXPECT_EQ(half.poses[0].x, 2.0);
  EXPECT_EQ(half.poses[1].x, 2.0);
  const ParticleSet other = heavier_half(a, 1.0, b, 1.0);
  EXPECT_EQ(other.poses[0].x, 1.0);
  EXPECT_NEAR(other.log_weights[0], std::log(0.9), 1e-12);
  EXPECT_EQ(other.poses[1].x, 2.0);
}

}  // namespace
}  // namespace castaway::localization
