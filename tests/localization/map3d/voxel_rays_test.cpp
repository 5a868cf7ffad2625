#include "localization/map3d/voxel_rays.hpp"

#include <gtest/gtest.h>
#include <boost/random/uniform_real_distribution.hpp>

#include "localization/geometry/random.hpp"
#include "localization/map3d/voxel_builder.hpp"

namespace castaway::localization {
namespace {

/// Walls x = 2 and x = 5 of 6 m x 3 m, and the floor z = 0.
VoxelDistances two_walls() {
  VoxelBuilder builder(0.1);
  for (int i = 0; i < 300; ++i) {
    for (int k = 0; k < 150; ++k) {
      const double y = -3.0 + 0.02 * i;
      builder.add({2.01, y, 0.02 * k});
      builder.add({5.01, y, 0.02 * k});
      builder.add({6.0 * i / 300.0, 6.0 * k / 150.0 - 3.0, 0.0});
    }
  }
  return VoxelDistances(builder.build(), 0.4);
}

TEST(MeetsSurface, OnlyWhereAWallIsInTheWay) {
  const VoxelDistances distances = two_walls();
  EXPECT_TRUE(meets_surface(distances, {0.5F, 0.0F, 1.0F}, {3.0F, 0.5F, 1.2F}));
  EXPECT_FALSE(meets_surface(distances, {0.5F, 0.0F, 1.0F}, {1.7F, 0.5F, 1.2F}));
  EXPECT_FALSE(meets_surface(distances, {0.5F, 0.0F, 1.0F}, {3.0F, 0.0F, 6.0F}));  // Over it.
  EXPECT_FALSE(meets_surface(distances, {2.5F, 0.0F, 1.0F}, {4.7F, 1.0F, 1.0F}));
}

TEST(MeetsSurface, WhereTheRayBeginsDoesNotCount) {
  const VoxelDistances distances = two_walls();
  EXPECT_FALSE(meets_surface(distances, {2.01F, 0.0F, 1.0F}, {4.7F, 0.0F, 1.0F}));
  EXPECT_TRUE(meets_surface(distances, {2.01F, 0.0F, 1.0F}, {5.5F, 0.0F, 1.0F}));
  EXPECT_FALSE(meets_surface(distances, {1.0F, 0.0F, 1.0F}, {1.0F, 0.0F, 1.0F}));
}

TEST(MeetsSurface, NoRayPassesThroughAWall) {
  const VoxelDistances distances = two_walls();
  Rng rng(5);
  const auto draw = [&](float low, float high) {
    return boost::random::uniform_real_distribution<float>(low, high)(rng);
  };
  for (int i = 0; i < 5000; ++i) {
    const Eigen::Vector3f from(draw(-6.0F, 1.8F), draw(-2.5F, 2.5F), draw(0.3F, 2.5F));
    const Eigen::Vector3f to(draw(2.3F, 4.8F), draw(-2.5F, 2.5F), draw(0.3F, 2.5F));
    EXPECT_TRUE(meets_surface(distances, from, to)) << from.transpose() << " " << to.transpose();
  }
}

}  // namespace
}  // namespace castaway::localization
