#include "localization/hypotheses/quality_rules.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace castaway::localization {
namespace {

Hypothesis at(int id, const SE2& pose, double quality, int particles = 2) {
  Hypothesis h;
  h.id = id;
  h.particles.poses.assign(static_cast<std::size_t>(particles), pose);
  h.particles.log_weights.assign(static_cast<std::size_t>(particles), 0.0);
  h.belief.mean = pose;
  h.quality = quality;
  return h;
}

TEST(MergeByWeight, KeepsTheHeavierParticlesOfBoth) {
  std::vector<Hypothesis> all = {at(0, {1, 1, 0}, 0.4), at(1, {1.1, 1, 0}, 0.8),
                                 at(2, {5, 5, 0}, 0.3)};
  merge_by_weight({0.2, 0.3}, all);
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].id, 0);
  EXPECT_EQ(all[0].quality, 0.8);
  for (const SE2& pose : all[0].particles.poses) EXPECT_EQ(pose.x, 1.1);
  EXPECT_NEAR(all[0].belief.mean.x, 1.1, 1e-12);
}

TEST(DestroyByQuality, RemovesTheBadButNeverTheBest) {
  std::vector<Hypothesis> all = {at(0, {}, 0.1), at(1, {}, 0.2), at(2, {}, 0.05)};
  destroy_by_quality({}, all);
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].id, 1);
  std::vector<Hypothesis> none;
  destroy_by_quality({}, none);
  EXPECT_TRUE(none.empty());
}

TEST(IsApart, NeedsDistanceOrAnotherHeading) {
  const std::vector<Hypothesis> all = {at(0, {1, 1, 0}, 0.5)};
  EXPECT_FALSE(is_apart({}, all, {1.3, 1, 0.5}));
  EXPECT_TRUE(is_apart({}, all, {1.6, 1, 0.0}));
  EXPECT_TRUE(is_apart({}, all, {1.0, 1, 3.0}));
}

PublishedDefects with(bool PublishedDefects::*defect) {
  PublishedDefects defects;
  defects.*defect = true;
  return defects;
}

TEST(MergeByWeight, ScalesThePositionByTheSumOfTheWeightsWhenUnnormalised) {
  // Each population has one particle that carries 0.9 of its weight: the heavier half sums to 1.8.
  std::vector<Hypothesis> all = {at(0, {1, 2, 0.5}, 0.4), at(1, {1, 2, 0.5}, 0.8)};
  for (Hypothesis& h : all) h.particles.log_weights = {std::log(0.9), std::log(0.1)};
  std::vector<Hypothesis> normalised = all;
  merge_by_weight({0.2, 0.3}, all, with(&PublishedDefects::unnormalised_merge));
  ASSERT_EQ(all.size(), 1U);
  EXPECT_NEAR(all[0].belief.mean.x, 1.8, 1e-12);
  EXPECT_NEAR(all[0].belief.mean.y, 3.6, 1e-12);
  EXPECT_NEAR(all[0].belief.mean.yaw, 0.5, 1e-12);
  merge_by_weight({0.2, 0.3}, normalised);
  EXPECT_NEAR(normalised[0].belief.mean.x, 1.0, 1e-12);
}

TEST(MergeByWeight, ComparesTheFirstOnlyWhenAsked) {
  const std::vector<Hypothesis> all = {at(0, {1, 1, 0}, 0.4), at(1, {5, 5, 0}, 0.8),
                                       at(2, {5, 5, 0}, 0.3)};
  std::vector<Hypothesis> any = all;
  merge_by_weight({0.2, 0.3}, any);
  EXPECT_EQ(any.size(), 2U);
  std::vector<Hypothesis> first = all;
  merge_by_weight({0.2, 0.3}, first, with(&PublishedDefects::first_merges_only));
  EXPECT_EQ(first.size(), 3U);
}

TEST(Removal, TakesTheSuccessorOfTheRemovedForIt) {
  const std::vector<Hypothesis> all = {at(0, {}, 0.5), at(1, {5, 5, 0}, 0.1),
                                       at(2, {8, 8, 0}, 0.9)};
  const PublishedDefects neighbour = with(&PublishedDefects::neighbour_compared);
  std::vector<Hypothesis> right = all;
  EXPECT_EQ(destroy_by_quality({}, right, {}, 2), 2);  // the good output stays the output
  std::vector<Hypothesis> wrong = all;
  EXPECT_EQ(destroy_by_quality({}, wrong, neighbour, 2), 0);  // and here the first becomes it
  std::vector<Hypothesis> unnoticed = all;
  EXPECT_EQ(destroy_by_quality({}, unnoticed, neighbour, 1), 1);  // the removed itself
  std::vector<Hypothesis> merging = {at(0, {}, 0.5), at(1, {}, 0.4), at(2, {8, 8, 0}, 0.9)};
  EXPECT_EQ(merge_by_weight({0.2, 0.3}, merging, neighbour, 2), 0);
}

TEST(AbsoluteGates, DestroyBelowATenthOrBelowAQuarterWhenFull) {
  const PublishedDefects gates = with(&PublishedDefects::absolute_gates);
  std::vector<Hypothesis> few = {at(0, {}, 0.2), at(1, {}, 0.05)};
  destroy_by_quality({}, few, gates);
  ASSERT_EQ(few.size(), 1U);
  EXPECT_EQ(few[0].id, 0);
  std::vector<Hypothesis> full = {at(0, {}, 0.2), at(1, {}, 0.3), at(2, {}, 0.24), at(3, {}, 0.9),
                                  at(4, {}, 0.7)};
  destroy_by_quality({}, full, gates);
  EXPECT_EQ(full.size(), 4U);  // then it is no longer full
  EXPECT_EQ(full[0].id, 1);
  std::vector<Hypothesis> bad = {at(0, {}, 0.09), at(1, {}, 0.01)};
  destroy_by_quality({}, bad, gates);
  ASSERT_EQ(bad.size(), 1U);
  EXPECT_EQ(bad[0].id, 1);  // the last, not the best
}

TEST(AbsoluteGates, SelectOnlyTheGoodByAMargin) {
  const auto output = [](double present, double other) {
    return output_by_gates({}, {at(0, {}, present), at(1, {}, other)}, 0);
  };
  EXPECT_EQ(output(0.1, 0.61), 1);
  EXPECT_EQ(output(0.1, 0.55), 0);   // right among people: never selected
  EXPECT_EQ(output(0.45, 0.64), 0);  // good, but not by the margin
  EXPECT_EQ(output_by_gates({}, {at(3, {}, 0.1), at(4, {}, 0.2)}, 9), 3);  // the output is gone
}

}  // namespace
}  // namespace castaway::localization
