#include "tools/outputs/pictures/picture_scenes.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/tools/support/records.hpp"
#include "tools/outputs/pictures/chase_view.hpp"

namespace castaway::testbed {
namespace {

using Eigen::Vector3f;

/// A wall across x, 4 m wide and 2.5 m high, at x = -0.6 m.
sim::SceneItem wall_behind() {
  sim::SceneItem wall;
  wall.mesh.vertices = {{-0.6F, -2, 0}, {-0.6F, 2, 0}, {-0.6F, 2, 2.5F}, {-0.6F, -2, 2.5F}};
  wall.mesh.indices = {0, 1, 2, 0, 2, 3};
  return wall;
}

TEST(ChaseScene, SeesTheRobotBesideWhatMoves) {
  PictureWorld world;
  const ScanRecord record = record_at(0.0, {});  // The robot is at the origin.
  EXPECT_LT(chase_scene(world, record, std::nullopt).camera.eye.x(), -0.6F);
  world.moving = [] { return std::vector{wall_behind()}; };
  const sim::Scene scene = chase_scene(world, record, std::nullopt);
  EXPECT_FALSE(is_hidden({wall_behind()}, Vector3f(0, 0, 0.25F), scene.camera.eye));
  ASSERT_EQ(scene.items.size(), 1U);
}

TEST(ChaseScene, ShowsTheRobotOnARampAsItStands) {
  PictureWorld world;
  world.robot = {wall_behind()};
  world.T_footprint_base = [] {
    const Eigen::Isometry3d up(Eigen::Translation3d(0.0, 0.0, 0.25));
    return up * Eigen::AngleAxisd(-0.1, Eigen::Vector3d::UnitY());  // Nose up.
  };
  ScanRecord record = record_at(0.0, {"near"});
  record.scan.ranges = {2.0F};
  const sim::Scene scene = chase_scene(world, record, std::nullopt);
  EXPECT_NEAR(scene.items.front().T_map_mesh.translation().z(), 0.25, 1e-6);
  EXPECT_NEAR(scene.camera.eye.z(), 1.95, 1e-5);  // 1.7 m above the robot.
  ASSERT_EQ(scene.points.front().points.size(), 1U);
  EXPECT_NEAR(scene.points.front().points.front().z(), 0.25 + 2.0 * std::sin(0.1), 1e-5);
  EXPECT_NEAR(scene.items.back().T_map_mesh.translation().z(), 0.27, 1e-5);  // The ghost's arrow.
}

/// A slab of 1 m x 1 m at a height.
sim::SceneItem slab_at(float z) {
  sim::SceneItem slab;
  slab.mesh.vertices = {{0, 0, z}, {1, 0, z}, {1, 1, z}, {0, 1, z}};
  slab.mesh.indices = {0, 1, 2, 0, 2, 3};
  return slab;
}

TEST(OverviewScene, ShowsTheFloorOnWhichTheRobotIs) {
  PictureWorld world;
  world.world = {slab_at(0.0F), slab_at(3.0F), slab_at(6.0F), wall_behind()};
  world.lowest_ground = [](const Eigen::Vector2d&) { return 0.0; };
  ScanRecord record = record_at(0.0, {});
  EXPECT_EQ(overview_scene(world, record, std::nullopt).items.size(), 4U);
  record.true_pose->T_footprint_base = Eigen::Isometry3d(Eigen::Translation3d(0.0, 0.0, 3.0));
  EXPECT_EQ(overview_scene(world, record, std::nullopt).items.size(), 3U);
  record.true_pose->T_footprint_base->translation().z() = 0.0;
  EXPECT_EQ(overview_scene(world, record, std::nullopt).items.size(), 2U);
}

TEST(OverviewScene, ShowsWhatStandsHigherOnAHill) {
  PictureWorld world;
  world.world = {slab_at(0.0F), slab_at(6.0F)};
  world.lowest_ground = [](const Eigen::Vector2d&) { return 6.0; };
  ScanRecord record = record_at(0.0, {});
  record.true_pose->T_footprint_base = Eigen::Isometry3d::Identity();
  EXPECT_EQ(overview_scene(world, record, std::nullopt).items.size(), 2U);
}

TEST(OverviewScene, DrawsEstimatesOnTheirFloors) {
  PictureWorld world;
  ScanRecord record = record_at(0.0, {"above", "planar"});
  record.true_pose->T_footprint_base = Eigen::Isometry3d(Eigen::Translation3d(0.0, 0.0, 3.0));
  record.localizers[0].estimate->footing = {6.0, 2};
  const sim::Scene scene = overview_scene(world, record, std::nullopt);
  ASSERT_EQ(scene.items.size(), 2U);  // The arrows.
  EXPECT_NEAR(scene.items[0].T_map_mesh.translation().z(), 6.02, 1e-5);
  EXPECT_NEAR(scene.items[1].T_map_mesh.translation().z(), 0.024, 1e-5);
}

}  // namespace
}  // namespace castaway::testbed
