#include "localization/paper/published/published_config.hpp"

#include <gtest/gtest.h>

namespace castaway::localization {
namespace {

TEST(PublishedConfig, HasAllDefectsAndThePublishedFigures) {
  const PublishedMhAmclConfig config = published_config();
  EXPECT_EQ(config.defects, all_defects());
  EXPECT_EQ(config.paper.candidate_sigma, 0.1);
  EXPECT_EQ(config.paper.candidate_sigma_yaw, 0.05);
  EXPECT_EQ(config.paper.reseed.winners, 0.03);
  EXPECT_EQ(config.paper.reseed.spread_m, 0.1);
  EXPECT_EQ(config.paper.reseed.spread_rad, 0.05);
  EXPECT_EQ(PublishedMhAmclConfig{}.defects, PublishedDefects{});
}

}  // namespace
}  // namespace castaway::localization
