#include "localization/paper/published/published_rules.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/localization/paper/paper_cases.hpp"

namespace castaway::localization {
namespace {

PublishedMhAmclConfig rules_with(bool PublishedDefects::*defect) {
  PublishedMhAmclConfig config;
  config.defects.*defect = true;
  return config;
}

Populations merge(Populations populations, const PublishedMhAmclConfig& config) {
  published_merge({0.2, 0.3}, config.defects, populations);
  return populations;
}

Populations destroy(Populations populations, const PublishedMhAmclConfig& config) {
  published_destroy(config, populations);
  return populations;
}

TEST(PublishedMerge, IsThePapersWithoutDefects) {
  const Populations all{{hypothesis_at(0, {1, 1, 0}, 0.4), hypothesis_at(1, {1.1, 1, 0}, 0.8),
                         hypothesis_at(2, {5, 5, 0}, 0.3)}};
  std::vector<Hypothesis> paper = all.all;
  merge_by_weight({0.2, 0.3}, paper);
  const Populations merged = merge(all, {});
  ASSERT_EQ(merged.all.size(), 2U);
  EXPECT_EQ(merged.all[0].particles.poses, paper[0].particles.poses);
  EXPECT_EQ(merged.all[0].particles.log_weights, paper[0].particles.log_weights);
  EXPECT_EQ(merged.all[0].belief.mean, paper[0].belief.mean);
  EXPECT_EQ(merged.all[0].quality, 0.8);
}

TEST(PublishedMerge, ScalesThePositionByTheSumOfTheWeightsWhenUnnormalised) {
  // Each population has one particle with 0.9 of its weight, so the heavier half sums to 1.8.
  Populations all{{hypothesis_at(0, {1, 2, 0.5}, 0.4), hypothesis_at(1, {1, 2, 0.5}, 0.8)}};
  for (Hypothesis& h : all.all) h.particles.log_weights = {std::log(0.9), std::log(0.1)};
  const Populations merged = merge(all, rules_with(&PublishedDefects::unnormalised_merge));
  ASSERT_EQ(merged.all.size(), 1U);
  EXPECT_NEAR(merged.all[0].belief.mean.x, 1.8, 1e-12);
  EXPECT_NEAR(merged.all[0].belief.mean.y, 3.6, 1e-12);
  EXPECT_NEAR(merged.all[0].belief.mean.yaw, 0.5, 1e-12);
  EXPECT_NEAR(merge(all, {}).all[0].belief.mean.x, 1.0, 1e-12);
}

TEST(PublishedMerge, ComparesTheFirstOnlyWhenAsked) {
  const Populations all{{hypothesis_at(0, {1, 1, 0}, 0.4), hypothesis_at(1, {5, 5, 0}, 0.8),
                         hypothesis_at(2, {5, 5, 0}, 0.3)}};
  EXPECT_EQ(merge(all, {}).all.size(), 2U);
  EXPECT_EQ(merge(all, rules_with(&PublishedDefects::first_merges_only)).all.size(), 3U);
}

TEST(PublishedRemoval, TakesTheSuccessorOfTheRemovedForIt) {
  Populations all{{hypothesis_at(0, {}, 0.5), hypothesis_at(1, {5, 5, 0}, 0.1),
                   hypothesis_at(2, {8, 8, 0}, 0.9)},
                  2};
  const PublishedMhAmclConfig neighbour = rules_with(&PublishedDefects::neighbour_compared);
  EXPECT_EQ(destroy(all, {}).output_id, 2);         // the good output is kept
  EXPECT_EQ(destroy(all, neighbour).output_id, 0);  // here the first one becomes the output
  all.output_id = 1;
  EXPECT_EQ(destroy(all, neighbour).output_id, 1);  // the removed one itself
  const Populations merging{
      {hypothesis_at(0, {}, 0.5), hypothesis_at(1, {}, 0.4), hypothesis_at(2, {8, 8, 0}, 0.9)}, 2};
  EXPECT_EQ(merge(merging, neighbour).output_id, 0);
  EXPECT_EQ(merge(merging, {}).output_id, 2);
}

TEST(PublishedDestroy, IsThePapersWithoutDefects) {
  const Populations left = destroy({{hypothesis_at(0, {}, 0.1), hypothesis_at(1, {}, 0.2),
                                     hypothesis_at(2, {}, 0.05), hypothesis_at(3, {}, 0.15)}},
                                   {});
  ASSERT_EQ(left.all.size(), 1U);
  EXPECT_EQ(left.all[0].id, 1);
  EXPECT_TRUE(destroy({}, {}).all.empty());
}

TEST(PublishedDestroy, GoesByTheGatesWhenAsked) {
  const PublishedMhAmclConfig gates = rules_with(&PublishedDefects::absolute_gates);
  const Populations few = destroy({{hypothesis_at(0, {}, 0.2), hypothesis_at(1, {}, 0.05)}}, gates);
  ASSERT_EQ(few.all.size(), 1U);
  EXPECT_EQ(few.all[0].id, 0);
  const Populations full =
      destroy({{hypothesis_at(0, {}, 0.2), hypothesis_at(1, {}, 0.3), hypothesis_at(2, {}, 0.24),
                hypothesis_at(3, {}, 0.9), hypothesis_at(4, {}, 0.7)}},
              gates);
  EXPECT_EQ(full.all.size(), 4U);  // then it is no longer full
  EXPECT_EQ(full.all[0].id, 1);
  const Populations bad =
      destroy({{hypothesis_at(0, {}, 0.09), hypothesis_at(1, {}, 0.01)}}, gates);
  ASSERT_EQ(bad.all.size(), 1U);
  EXPECT_EQ(bad.all[0].id, 1);  // the last one, not the best one
}

}  // namespace
}  // namespace castaway::localization
