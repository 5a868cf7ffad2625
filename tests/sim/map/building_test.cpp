#include "sim/map/building.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "sim/map/grid_tools.hpp"
#include "sim/map/rasterise.hpp"
#include "tests/sim/support/test_world.hpp"

namespace castaway::sim {
namespace {

constexpr double kRobot = 0.2;

/// A house of 8 m x 6 m with a door of `gap` [m] in its southern wall, and a box 5 m north of it.
WorldSpec house(double gap) {
  const double half = 0.5 * (8.0 - gap);
  WorldSpec world;
  world.name = "house";
  world.objects = {box_on_floor("north", {8.0, 0.1, 1.0}, {0.0, 3.0}),
                   box_on_floor("west", {0.1, 6.0, 1.0}, {-4.0, 0.0}),
                   box_on_floor("east", {0.1, 6.0, 1.0}, {4.0, 0.0}),
                   box_on_floor("south-west", {half, 0.1, 1.0}, {-4.0 + 0.5 * half, -3.0}),
                   box_on_floor("south-east", {half, 0.1, 1.0}, {4.0 - 0.5 * half, -3.0}),
                   box_on_floor("box", {1.0, 1.0, 1.0}, {0.0, 8.0})};
  world.min_corner = {-10.0, -10.0};
  world.max_corner = {10.0, 10.0};
  return world;
}

TEST(Building, IsWhatWallsWithDoorsEnclose) {
  for (const double door : {0.9, 1.6, 2.6}) {
    const auto building = enclosed_building(cut_world(house(door), 0.2, 0.1), kRobot);
    ASSERT_TRUE(building) << door;
    EXPECT_EQ(cell_at(building->grid, {0.05, 0.05}), Cell::kFree);
    EXPECT_EQ(cell_at(building->grid, {-3.75, 2.75}), Cell::kFree);
    EXPECT_EQ(cell_at(building->grid, {0.05, -5.05}), Cell::kUnknown);
    EXPECT_EQ(cell_at(building->grid, {0.05, 6.05}), Cell::kUnknown);
    EXPECT_EQ(cell_at(building->grid, {0.05, 8.05}), Cell::kOccupied);
  }
  EXPECT_FALSE(enclosed_building(cut_world(house(5.0), 0.2, 0.1), kRobot));
}

/// A closet is closed, the rest of the house is behind a wide door.
TEST(Building, IsAllOfItRatherThanItsNarrowestRoom) {
  WorldSpec world = house(1.6);
  world.objects.push_back(box_on_floor("inner-south", {3.0, 0.1, 1.0}, {-2.5, -2.4}));
  world.objects.push_back(box_on_floor("inner", {0.1, 5.4, 1.0}, {-1.0, 0.3}));
  const auto building = enclosed_building(cut_world(world, 0.2, 0.1), kRobot);
  ASSERT_TRUE(building);
  EXPECT_EQ(cell_at(building->grid, {2.05, 0.05}), Cell::kFree);
}

TEST(Building, IsWhereModelsStandIfNothingIsEnclosed) {
  const auto place = between_obstacles(cut_world(house(5.0), 0.2, 0.1), kRobot);
  ASSERT_TRUE(place);
  EXPECT_EQ(cell_at(place->grid, {0.05, -3.75}), Cell::kFree);
  EXPECT_EQ(cell_at(place->grid, {0.05, -5.05}), Cell::kUnknown);
  EXPECT_EQ(cell_at(place->grid, {3.05, 6.05}), Cell::kFree);
  WorldSpec one = house(5.0);
  one.objects = {one.objects.back()};
  EXPECT_FALSE(between_obstacles(cut_world(one, 0.2, 0.1), kRobot));
}

TEST(Building, IsTheWholeOfACroppedGrid) {
  const auto building = enclosed_building(cut_world(house(0.9), 0.2, 0.1), kRobot);
  ASSERT_TRUE(building);
  const Grid cropped = crop_to_free(building->grid);
  EXPECT_LE(cropped.width, 105);
  EXPECT_LE(cropped.height, 90);
  for (const Eigen::Vector2d& p :
       {Eigen::Vector2d(0.05, 0.05), Eigen::Vector2d(-3.95, 0.05), Eigen::Vector2d(3.95, 2.95)}) {
    EXPECT_EQ(cell_at(cropped, p), cell_at(building->grid, p));
  }
}

TEST(MetExtent, LeavesOutSpecksFarAway) {
  WorldSpec world = house(0.9);
  world.min_corner = {-400.0, -300.0};
  world.max_corner = {401.0, 300.0};
  world.objects.push_back(box_on_floor("speck", {0.01, 0.01, 0.3}, {-400.0, -300.0}));
  world.objects.push_back(box_on_floor("speck2", {0.01, 0.01, 0.3}, {400.0, 300.0}));
  const auto box = met_extent(world, 0.1, 0.6);
  ASSERT_TRUE(box);
  EXPECT_TRUE(
      box->contains(Eigen::AlignedBox2d(Eigen::Vector2d(-4.0, -3.0), Eigen::Vector2d(4.0, 8.5))));
  EXPECT_LT(box->sizes().maxCoeff(), 20.0);
}

TEST(MetExtent, IsKeptIfItIsFullOrSmall) {
  WorldSpec world = house(0.9);
  EXPECT_FALSE(met_extent(world, 0.1, 0.6));
  world.max_corner = {200.0, 10.0};
  for (int i = 0; i < 10; ++i) {
    world.objects.push_back(box_on_floor("car", {4.0, 2.0, 1.0}, {20.0 * i, 0.0}));
  }
  EXPECT_FALSE(met_extent(world, 0.1, 0.6));
}

}  // namespace
}  // namespace castaway::sim
