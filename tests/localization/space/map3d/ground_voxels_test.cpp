#include "localization/space/map3d/ground_voxels.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "localization/space/map3d/survey_ground.hpp"
#include "localization/space/map3d/voxel_builder.hpp"
#include "localization/space/volume/voxel_distances.hpp"
#include "tests/localization/space/volume/single_rays.hpp"

namespace castaway::localization {
namespace {

using test::encounter;

/// Rolling ground of 12 m x 4 m with a wall across it at x = 9, 2 m high.
VoxelMap rolling_ground() {
  VoxelBuilder builder(0.1);
  for (double x = 0.0125; x < 12.0; x += 0.025) {
    for (double y = 0.0125; y < 4.0; y += 0.025) {
      builder.add({x, y, 0.25 * std::sin(x)}, true);
    }
  }
  for (double y = 0.0125; y < 4.0; y += 0.025) {
    for (double z = 0.0125; z < 2.0; z += 0.025) builder.add({9.05, y, 0.1 + z}, false);
  }
  return builder.build();
}

TEST(WithoutGround, KeepsWhatStandsOnIt) {
  const VoxelMap all = rolling_ground();
  const VoxelMap kept = without_ground(all, survey_ground(all, GroundConfig{}));
  std::size_t of_wall = 0;
  std::size_t of_ground = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Eigen::Vector3d p = all.point(i);
    const bool inside = p.x() > 0.3 && p.x() < 8.5 && p.y() > 0.3 && p.y() < 3.7;
    const bool is_kept = kept.contains(voxel_of(p, all.resolution));
    if (inside) of_ground += is_kept ? 1U : 0U;
    if (p.x() > 9.0 && p.x() < 9.1 && p.z() > 0.5) {
      EXPECT_TRUE(is_kept);
      ++of_wall;
    }
  }
  EXPECT_EQ(of_ground, 0U);
  EXPECT_GT(of_wall, 500U);
  EXPECT_NO_THROW(validate(kept));
}

TEST(WithoutGround, LevelBeamsGrazeTheGroundAndPassNoWall) {
  const VoxelMap all = rolling_ground();
  const VoxelDistances everything(all, 0.4);
  const VoxelDistances walls(without_ground(all, survey_ground(all, GroundConfig{})), 0.4);
  // Just above the first crest, where x is half of pi.
  const Eigen::Vector3f from(0.5F, 2.0F, 0.28F);
  const Eigen::Vector3f to(5.0F, 2.0F, 0.28F);
  EXPECT_EQ(encounter(everything, from, to), Encounter::kPassed);
  EXPECT_EQ(encounter(walls, from, to), Encounter::kNone);
  EXPECT_EQ(encounter(walls, from, {11.0F, 2.0F, 0.28F}), Encounter::kPassed);
  EXPECT_EQ(encounter(walls, from, {9.05F, 2.0F, 0.28F}), Encounter::kReached);
}

}  // namespace
}  // namespace castaway::localization
