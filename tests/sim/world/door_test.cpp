#include "sim/world/door.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "sim/casting/ray_shapes.hpp"
#include "sim/map/rasterise.hpp"
#include "tests/sim/support/test_world.hpp"

namespace castaway::sim {
namespace {

/// Hinged at (1, 2), closed along x.
Door door() {
  Door result;
  result.name = "door";
  result.T_map_hinge = Eigen::Translation3d(1.0, 2.0, 0.0);
  result.leaf = {0.9, 0.04, 2.0};
  return result;
}

WorldSpec world_with_door() {
  WorldSpec world;
  world.name = "w";
  world.max_corner = {4.0, 4.0};
  world.doors = {door()};
  world.objects = {door_leaf(door(), 0.0)};
  return world;
}

TEST(Door, TurnsAboutItsHinge) {
  EXPECT_TRUE(
      door_leaf(door(), 0.0).T_map_object.translation().isApprox(Eigen::Vector3d(1.45, 2.0, 1.0)));
  EXPECT_TRUE(
      door_leaf(door(), 90.0).T_map_object.translation().isApprox(Eigen::Vector3d(1.0, 2.45, 1.0)));
  Door other = door();
  other.turn = -1.0;
  EXPECT_TRUE(
      door_leaf(other, 90.0).T_map_object.translation().isApprox(Eigen::Vector3d(1.0, 1.55, 1.0)));
}

TEST(Door, OpensInTheWorldAndStaysOnTheMap) {
  WorldSpec world = world_with_door();
  const Grid before = rasterise(world, 0.2, 0.1);
  set_door(world, "door", 90.0);
  EXPECT_EQ(rasterise(world, 0.2, 0.1).cells, before.cells);
  const auto primitives = ray_primitives(world);
  ASSERT_EQ(primitives.size(), 1U);
  EXPECT_TRUE(primitives[0].T_map_shape.translation().isApprox(Eigen::Vector3d(1.0, 2.45, 1.0)));
  set_door(world, "door", 45.0);
  EXPECT_EQ(ray_primitives(world).size(), 1U);
  EXPECT_EQ(world.doors[0].open_deg, 45.0);
}

TEST(Door, MustBeThere) {
  WorldSpec world = world_with_door();
  EXPECT_THROW(set_door(world, "gate", 90.0), std::invalid_argument);
}

}  // namespace
}  // namespace castaway::sim
