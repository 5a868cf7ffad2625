#include "localization/hypotheses/quality_rules.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/string_map.hpp"

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

TEST(CorrectByRays, MultipliesWeightsAndTakesTheQualityOfEquation9) {
  const OccupancyGrid grid = test::string_map({"..........#........."}, 0.05);
  const RayLocalModel model({0.05}, grid);
  const ScanPoints points{{0.5F}, {0.0F}, {0.0F}, {0.0F}, {0.5F}};
  Hypothesis h = at(0, {0.025, 0.025, 0.0}, 0.0);
  h.particles.poses[1] = {0.075, 0.025, 0.0};  // ends one cell behind the wall
  h.particles.log_weights = {-1.0, -1.0};
  correct_by_rays(h, model, points);
  EXPECT_NEAR(h.particles.log_weights[0], -1.0, 1e-9);
  EXPECT_NEAR(h.particles.log_weights[1], -1.5, 1e-9);
  EXPECT_NEAR(h.quality, (1.0 + std::exp(-0.5)) / 2.0, 1e-9);
  const Hypothesis before = h;
  correct_by_rays(h, model, {});
  EXPECT_EQ(h.quality, before.quality);
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

}  // namespace
}  // namespace castaway::localization
