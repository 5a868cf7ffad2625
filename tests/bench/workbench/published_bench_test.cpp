#include "tests/bench/workbench/published_bench.hpp"

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

TEST(PlayVariants, ScoresAllVariantsOnTheSameRuns) {
  Scenario scenario;
  scenario.duration_s = 12.0;
  scenario.drive.route = "none";
  scenario.events.simulated.kidnaps.emplace_back().when.value = 1.0;
  std::vector<PublishedVariant> variants = published_variants();
  // The wrapping of yaw in the covariance changes no pose.
  variants = {variants.front(), variants.back(), variants.front()};
  variants[2].name = "+ unwrapped_yaw";
  variants[2].config.defects.unwrapped_yaw = true;
  int runs = 0;
  const std::vector<VariantScore> scores =
      play_variants(scenario, ".", variants, 2, [&runs] { ++runs; });
  EXPECT_EQ(runs, 2);
  ASSERT_EQ(scores.size(), 3U);
  EXPECT_EQ(scores[0].name, "paper");
  EXPECT_EQ(scores[1].name, "published");
  for (const VariantScore& score : scores) {
    EXPECT_EQ(score.events, 2);
    EXPECT_EQ(score.wrong.size(), 2U);
  }
  EXPECT_EQ(scores[2].wrong, scores[0].wrong);  // the same random numbers
  EXPECT_EQ(scores[2].tracking_m, scores[0].tracking_m);
}

}  // namespace
}  // namespace castaway::testbed
