#include "tools/build/scene/visible_scene.hpp"

#include <gtest/gtest.h>

#include "sim/scene/scene.hpp"
#include "sim/world/world_visuals.hpp"
#include "tools/build/scene/merged_mesh.hpp"

namespace castaway::testbed {
namespace {

/// A hall of 10 m x 10 m with a table and a ceiling.
sim::WorldSpec hall() {
  sim::WorldSpec world;
  world.max_corner = {10.0, 10.0};
  sim::WorldObject table;
  table.shape = sim::BoxShape{{1.0, 2.0, 0.8}};
  table.T_map_object.translation() << 3.0, 4.0, 0.4;
  table.color = {0.2F, 0.4F, 0.6F};
  sim::WorldObject ceiling;
  ceiling.shape = sim::BoxShape{{10.0, 10.0, 0.1}};
  ceiling.T_map_object.translation() << 5.0, 5.0, 3.0;
  world.objects = {table, ceiling};
  return world;
}

TEST(VisibleScene, ShowsTheWorldAsPicturesDo) {
  const sim::WorldSpec world = hall();
  const PageWorld page = page_world(world);
  const std::vector<sim::SceneItem> open = sim::world_visuals_from_above(world);
  ASSERT_EQ(page.items.size(), open.size());
  const MergedMesh mesh = merge_items(page.items);
  std::size_t triangles = 0;
  Eigen::AlignedBox3f box;
  for (const sim::SceneItem& item : open) {
    triangles += item.mesh.indices.size() / 3;
    box.extend(sim::bounds_of(item));
  }
  EXPECT_EQ(mesh.indices.size(), 3 * triangles);
  Eigen::AlignedBox3f found;
  for (const Eigen::Vector3f& p : mesh.positions) found.extend(p);
  EXPECT_TRUE(found.isApprox(box));
  EXPECT_EQ(mesh.colors.front(), (std::array<std::uint8_t, 3>{51, 102, 153}));
}

TEST(VisibleScene, TheRoofIsApart) {
  const PageWorld page = page_world(hall());
  ASSERT_EQ(page.roofs.size(), 1U);
  EXPECT_NEAR(sim::bounds_of(page.roofs.front()).min().z(), 2.95F, 1e-5F);
  EXPECT_NEAR(page.top, 0.8, 1e-6);
  EXPECT_EQ(page.max_corner, Eigen::Vector2d(10.0, 10.0));
  EXPECT_EQ(page.floor_color, floor_item(hall()).color);
}

TEST(VisibleScene, ARobotWithoutALidarGetsOne) {
  sim::RobotModel robot;
  robot.visuals = {{"base", sim::BoxShape{{0.3, 0.3, 0.1}}, Eigen::Isometry3d::Identity(), {}}};
  robot.height = 0.1;
  sim::LidarConfig lidar;
  lidar.T_base_laser.translation() << 0.1, 0.0, 0.4;
  const std::size_t bare = robot_items(robot, {lidar}).size();
  EXPECT_GT(bare, 1U);
  robot.lidars.emplace_back();
  EXPECT_EQ(robot_items(robot, {lidar}).size(), 1U);
}

}  // namespace
}  // namespace castaway::testbed
