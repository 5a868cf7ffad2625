#include "sim/map/extrude.hpp"

#include <numbers>

#include <gtest/gtest.h>
#include <boost/random/uniform_int_distribution.hpp>

#include "sim/common/random.hpp"
#include "sim/map/grid_tools.hpp"
#include "sim/map/rasterise.hpp"
#include "tests/sim/support/test_world.hpp"

namespace castaway::sim {
namespace {

TEST(Extrude, MergesWallsIntoFewBoxes) {
  const WorldSpec world = extrude(grid_from_art({"#####",  //
                                                 "#...#",  //
                                                 "#...#",  //
                                                 "#####"},
                                                0.5),
                                  2.0, "room");
  ASSERT_EQ(world.objects.size(), 4U);
  const auto& south = std::get<BoxShape>(world.objects[0].shape);
  EXPECT_TRUE(south.size.isApprox(Eigen::Vector3d(2.5, 0.5, 2.0)));
  EXPECT_TRUE(
      world.objects[0].T_map_object.translation().isApprox(Eigen::Vector3d(1.25, 0.25, 1.0)));
  EXPECT_EQ(world.max_corner, Eigen::Vector2d(2.5, 2.0));
}

TEST(Extrude, HonoursTheYawOfTheOrigin) {
  Grid grid = grid_from_art({"..#"});
  grid.origin = {1.0, 1.0};
  grid.origin_yaw = std::numbers::pi / 2;
  const WorldSpec world = extrude(grid, 1.0, "turned");
  ASSERT_EQ(world.objects.size(), 1U);
  EXPECT_TRUE(
      world.objects[0].T_map_object.translation().isApprox(Eigen::Vector3d(0.5, 3.5, 0.5), 1e-12));
  EXPECT_TRUE(world.min_corner.isApprox(Eigen::Vector2d(0.0, 1.0), 1e-12));
  EXPECT_TRUE(world.max_corner.isApprox(Eigen::Vector2d(1.0, 4.0), 1e-12));
}

TEST(Extrude, ComesBackFromTheRasteriser) {
  Rng rng(5);
  boost::random::uniform_int_distribution<int> die(0, 3);
  Grid grid = make_grid(41, 33, 0.05, {-1.0, 0.3}, Cell::kFree);
  for (Cell& cell : grid.cells) cell = die(rng) == 0 ? Cell::kOccupied : Cell::kFree;
  const Grid again = rasterise(extrude(grid, 1.0, "noise"), 0.5, 0.05);
  ASSERT_EQ(again.width, grid.width);
  ASSERT_EQ(again.height, grid.height);
  EXPECT_EQ(art_of(again), art_of(largest_component(grid)));
}

}  // namespace
}  // namespace castaway::sim
