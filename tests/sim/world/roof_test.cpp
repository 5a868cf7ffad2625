#include "sim/world/roof.hpp"

#include <gtest/gtest.h>

#include "sim/scene/primitives.hpp"
#include "sim/world/world_visuals.hpp"

namespace castaway::sim {
namespace {

using Eigen::Vector3f;

SceneItem box(const Vector3f& size, const Vector3f& center) {
  SceneItem item;
  item.mesh = box_mesh(size);
  item.T_map_mesh.translation() = center;
  item.instance = 11;
  return item;
}

std::size_t roofs(const std::vector<SceneItem>& items) {
  std::size_t count = 0;
  for (const SceneItem& item : items) count += item.casts_shadow ? 0 : 1;
  return count;
}

TEST(PartRoofs, FindsASlabOverTheWorld) {
  const auto items =
      split_roofs({box({6, 0.1F, 2.5F}, {0, 3, 1.25F}), box({6, 6, 0.2F}, {0, 0, 2.6F})}, 36.0F);
  ASSERT_EQ(items.size(), 2U);
  EXPECT_TRUE(items[0].casts_shadow);
  EXPECT_FALSE(items[1].casts_shadow);  // Together with its sides.
  EXPECT_EQ(items[1].mesh.indices.size(), 36U);
}

TEST(PartRoofs, FindsACeilingOfPanels) {
  std::vector<SceneItem> panels;
  for (int i = 0; i < 16; ++i) {
    const auto x = static_cast<float>(i % 4);
    const auto y = static_cast<float>(i / 4);
    panels.push_back(box({0.98F, 0.98F, 0.05F}, {x, y, 2.4F}));
  }
  EXPECT_EQ(roofs(split_roofs(panels, 16.0F)), 16U);
  panels.resize(3);  // Lamps.
  EXPECT_EQ(roofs(split_roofs(panels, 16.0F)), 0U);
}

/// A closed room made of one mesh keeps its walls and its floor.
TEST(PartRoofs, PartsTheRoofOfAMesh) {
  const auto items = split_roofs({box({6, 6, 2.5F}, {0, 0, 1.25F})}, 36.0F);
  ASSERT_EQ(items.size(), 2U);
  EXPECT_EQ(items[0].mesh.indices.size(), 30U);
  EXPECT_EQ(items[1].mesh.indices.size(), 6U);
  EXPECT_FALSE(items[1].casts_shadow);
  EXPECT_EQ(items[1].instance, 11);
}

TEST(PartRoofs, FindsAHouseOnALargeGround) {
  EXPECT_EQ(roofs(split_roofs({box({6, 6, 2.5F}, {0, 0, 1.25F})}, 10000.0F)), 1U);
}

TEST(PartRoofs, FindsAPitchedRoof) {
  std::vector<SceneItem> sides{box({6, 4.2F, 0.1F}, {0, -1.5F, 3.5F}),
                               box({6, 4.2F, 0.1F}, {0, 1.5F, 3.5F})};
  sides[0].T_map_mesh.linear() = Eigen::AngleAxisf(0.7F, Vector3f::UnitX()).matrix();
  sides[1].T_map_mesh.linear() = Eigen::AngleAxisf(-0.7F, Vector3f::UnitX()).matrix();
  EXPECT_EQ(roofs(split_roofs(sides, 36.0F)), 2U);
}

TEST(PartRoofs, LeavesFurnitureAndLintels) {
  const auto items = split_roofs({box({1, 4, 2}, {0, 0, 1}),              // A rack.
                                  box({30, 30, 0.05F}, {0, 0, 0.75F}),    // A table.
                                  box({40, 0.2F, 0.5F}, {0, 0, 2.25F})},  // Above a door.
                                 100.0F);
  EXPECT_EQ(items.size(), 3U);
  EXPECT_EQ(roofs(items), 0U);
}

TEST(WorldVisualsFromAbove, LeaveOutTheRoof) {
  WorldSpec world;
  world.min_corner = {-3.0, -3.0};
  world.max_corner = {3.0, 3.0};
  WorldObject wall;
  wall.shape = BoxShape{{6.0, 0.1, 2.5}};
  wall.T_map_object.translation() = Eigen::Vector3d(0.0, 3.0, 1.25);
  WorldObject roof;
  roof.shape = BoxShape{{6.0, 6.0, 0.1}};
  roof.T_map_object.translation() = Eigen::Vector3d(0.0, 0.0, 2.6);
  world.objects = {roof, wall};
  ASSERT_EQ(world_visuals(world).size(), 2U);
  const auto open = world_visuals_from_above(world);
  ASSERT_EQ(open.size(), 1U);
  EXPECT_EQ(open[0].instance, kFirstObjectInstance + 1);
}

}  // namespace
}  // namespace castaway::sim
