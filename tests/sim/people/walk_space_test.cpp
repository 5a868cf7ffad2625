#include "sim/people/walk_space.hpp"

#include <gtest/gtest.h>

#include "sim/casting/ray_scene.hpp"
#include "tests/sim/support/people_scene.hpp"
#include "tests/sim/support/test_people.hpp"

namespace castaway::sim {
namespace {

TEST(BodyGrid, MarksWhatABodyMeetsAtAnyHeight) {
  TestHall hall(6.0);
  WorldObject table = box_on_floor("top", {1.0, 1.0, 0.04}, {1.0, 1.0});
  table.T_map_object.translation().z() = 0.72;
  WorldObject lamp = box_on_floor("lamp", {0.5, 0.5, 0.2}, {-1.0, -1.0});
  lamp.T_map_object.translation().z() = 2.2;
  hall.world.objects.push_back(table);
  hall.world.objects.push_back(lamp);
  const Grid grid = body_grid(hall.world, hall.map);
  EXPECT_EQ(cell_at(grid, {1.0, 1.0}), Cell::kOccupied);
  EXPECT_EQ(cell_at(grid, {-1.0, -1.0}), Cell::kFree);
}

TEST(WalkSpace, KeepsABodysWidthOffWalls) {
  const TestHall hall(6.0);
  const WalkSpace space(hall.map);
  EXPECT_TRUE(space.clear({2.7, 0.0}));
  EXPECT_FALSE(space.clear({2.8, 0.0}));
  EXPECT_FALSE(space.clear({9.0, 0.0}));
  EXPECT_TRUE(space.clear({-2.5, 0.0}, {2.5, 1.0}));
  EXPECT_FALSE(space.clear({-2.5, 0.0}, {3.5, 1.0}));
}

TEST(WalkSpace, KnowsDistanceAndDirectionOfTheWall) {
  const TestHall hall(6.0);
  const WallDistance wall = WalkSpace(hall.map).wall({2.2, 0.4});
  EXPECT_NEAR(wall.distance, 0.8, 0.05);
  EXPECT_NEAR(wall.away.x(), -1.0, 1e-6);
  EXPECT_NEAR(wall.away.y(), 0.0, 1e-6);
}

TEST(WalkSpace, SeesThroughTheOpenAndNotThroughWalls) {
  TestHall hall(6.0);
  hall.world.objects.push_back(box_on_floor("screen", {0.05, 2.0, 2.0}, {0.0, 0.0}));
  const WalkSpace space(body_grid(hall.world, hall.map));
  EXPECT_FALSE(space.sees({-1.0, 0.0}, {1.0, 0.0}));
  EXPECT_TRUE(space.sees({-1.0, 1.5}, {1.0, 1.5}));
}

/// The guarantee that nobody passes a wall is based on this: between two clear points within a step
/// there is nothing solid.
TEST(WalkSpace, HasNothingSolidWithinAStep) {
  WorldSpec world = test_room();
  const WalkSpace space(body_grid(world, test_simulation().map));
  const RayScene solid(ray_primitives(world));
  Rng rng(8);
  int steps = 0;
  for (int i = 0; i < 200000; ++i) {
    const Eigen::Vector2d from(draw_between(-4.0, 4.0, rng), draw_between(-3.0, 3.0, rng));
    const double heading = draw_between(-3.2, 3.2, rng);
    const Eigen::Vector2d ahead = heading_vector(heading);
    if (!space.clear(from) || !space.clear(from + WalkSpace::kMaxStep * ahead)) continue;
    ++steps;
    const Ray ray{{from.x(), from.y(), draw_between(0.05, 0.65, rng)}, {ahead.x(), ahead.y(), 0.0}};
    ASSERT_FALSE(solid.cast(ray, WalkSpace::kMaxStep).has_value());
  }
  EXPECT_GT(steps, 100000);
}

}  // namespace
}  // namespace castaway::sim
