#include "localization/space/map3d/atlas.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

namespace castaway::localization {
namespace {

/// A level road along x from 0, a ramp of 20 % from x = 4 to 14 m up to 2 m, a bridge of 2 m height
/// from there on that turns back over the road: cells of 0.1 m, 20 x 4 m.
ElevationMap bridge() {
  ElevationMap map;
  map.frame = {200, 40, 0.1, {}};
  map.levels = {0.0F, 2.0F};
  map.first.push_back(0);
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 200; ++x) {
      const float along = 0.1F * static_cast<float>(x) + 0.05F;
      const bool ramp_lane = y < 20;
      if (!ramp_lane || along < 4.0F) map.surfaces.push_back({0.0F, 0, 0, 1.8F, 0, true});
      if (ramp_lane && along >= 4.0F && along < 14.0F) {
        map.surfaces.push_back({0.2F * (along - 4.0F), 0.2F, 0, 9.0F, 0, true});
      }
      if (along >= 14.0F || !ramp_lane) map.surfaces.push_back({2.0F, 0, 0, 9.0F, 1, true});
      map.first.push_back(static_cast<std::uint32_t>(map.surfaces.size()));
    }
  }
  return map;
}

constexpr double kMargin = 1.0;

TEST(AtlasTest, HasEachSurfaceAtOnePlace) {
  const Atlas atlas(bridge(), kMargin);
  EXPECT_EQ(atlas.charts(), 2U);
  std::size_t own = 0;
  std::size_t all = 0;
  for (int y = 0; y < atlas.frame().height; ++y) {
    for (int x = 0; x < atlas.frame().width; ++x) {
      own += atlas.is_own({x, y}) ? 1 : 0;
      all += atlas.surface_at({x, y}) != nullptr ? 1 : 0;
    }
  }
  EXPECT_EQ(own, atlas.ground().surfaces.size());
  EXPECT_GT(all, own);  // Margins.
}

TEST(AtlasTest, PosesOfBothFloorsAreApart) {
  const Atlas atlas(bridge(), kMargin);
  const SE2 pose{10.02, 3.03, 0.5};
  const auto below = atlas.to_atlas(pose, 0.1);
  const auto above = atlas.to_atlas(pose, 1.9);
  ASSERT_TRUE(below && above);
  EXPECT_GT(distance(*below, *above), 10.0);
  for (const auto& [there, z] : {std::pair(*below, 0.0F), std::pair(*above, 2.0F)}) {
    const auto back = atlas.to_map(there);
    ASSERT_TRUE(back);
    EXPECT_LT(distance(back->T_map_base, pose), 1e-9);
    EXPECT_EQ(back->T_map_base.yaw, pose.yaw);
    EXPECT_EQ(back->surface->z, z);
  }
}

TEST(AtlasTest, ADriveLeadsFromChartToChart) {
  const Atlas atlas(bridge(), kMargin);
  SE2 pose = *atlas.to_atlas({1.0, 1.0, 0.0}, 0.0);
  int changes = 0;
  for (double x = 1.0; x < 18.0; x += 0.05) {
    const auto there = atlas.to_map(pose);
    ASSERT_TRUE(there) << x;
    EXPECT_NEAR(there->T_map_base.x, x, 1e-6);
    EXPECT_NEAR(there->T_map_base.y, 1.0, 1e-6);
    EXPECT_NEAR(static_cast<double>(there->surface->z), std::clamp(0.2 * (x - 4.0), 0.0, 2.0),
                0.02);
    const Eigen::Vector2d shift = atlas.to_own_chart(pose);
    changes += shift.norm() > 0.0 ? 1 : 0;
    pose = {pose.x + shift.x() + 0.05, pose.y + shift.y(), 0.0};
  }
  EXPECT_EQ(changes, 1);
  EXPECT_EQ(atlas.to_map(pose)->surface->level, 1);
}

TEST(AtlasTest, ATurnedGridShiftsAlongItsRows) {
  ElevationMap map = bridge();
  map.frame.T_map_grid = {5.0, -3.0, 0.7};
  const Atlas atlas(map, kMargin);
  const SE2 pose = map.frame.T_map_grid * SE2{10.02, 3.03, 0.0};
  const auto above = atlas.to_atlas(pose, 2.0);
  ASSERT_TRUE(above);
  const auto back = atlas.to_map(*above);
  ASSERT_TRUE(back);
  EXPECT_LT(distance(back->T_map_base, pose), 1e-9);
  EXPECT_EQ(back->surface->level, 1);
}

TEST(AtlasTest, WhereThereIsNoGroundThereIsNoPose) {
  const Atlas atlas(bridge(), kMargin);
  EXPECT_FALSE(atlas.to_atlas({-1.0, 1.0, 0.0}, 0.0));
  EXPECT_FALSE(atlas.to_map({-1.0, 1.0, 0.0}));
  EXPECT_EQ(atlas.to_own_chart({-1.0, 1.0, 0.0}), Eigen::Vector2d::Zero());
  ElevationMap map = bridge();
  for (GroundSurface& surface : map.surfaces) surface.drivable = false;
  EXPECT_THROW(Atlas(map, kMargin), std::invalid_argument);
}

}  // namespace
}  // namespace castaway::localization
