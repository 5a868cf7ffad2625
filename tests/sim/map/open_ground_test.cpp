#include "sim/map/open_ground.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace castaway::sim {
namespace {

/// A wall of 1 m x 4 m centred at (30, 0).
WorldSpec wall() {
  WorldSpec world;
  world.min_corner = {29.5, -2.0};
  world.max_corner = {30.5, 2.0};
  return world;
}

Ground plane(double width, double depth) {
  const Eigen::Vector2d half(0.5 * width, 0.5 * depth);
  return {0.0, {-half, half}};
}

TEST(OpenGround, IsAllOfAPlane) {
  WorldSpec world = wall();
  EXPECT_FALSE(extend_over(plane(100.0, 80.0), world));
  EXPECT_EQ(world.min_corner, Eigen::Vector2d(-50.0, -40.0));
  EXPECT_EQ(world.max_corner, Eigen::Vector2d(50.0, 40.0));
}

TEST(OpenGround, IsFiftyMetresAroundOfALargePlane) {
  WorldSpec world = wall();
  const auto line = extend_over(plane(1000.0, 60.0), world);
  EXPECT_THAT(line.value_or(""), testing::HasSubstr("1000 m x 60 m is used up to 50 m around"));
  EXPECT_EQ(world.min_corner, Eigen::Vector2d(-20.5, -30.0));
  EXPECT_EQ(world.max_corner, Eigen::Vector2d(80.5, 30.0));
}

TEST(OpenGround, IsFifteenMetresAroundWithoutASize) {
  WorldSpec world = wall();
  const auto line = extend_over({0.0, {}}, world);
  EXPECT_THAT(line.value_or(""), testing::HasSubstr("no size"));
  EXPECT_EQ(world.min_corner, Eigen::Vector2d(14.5, -17.0));
  EXPECT_EQ(world.max_corner, Eigen::Vector2d(45.5, 17.0));
}

TEST(NearObstacles, AreThePlacesWithinFiveMetres) {
  Grid grid{300, 200, 0.1, {0.0, 0.0}, 0.0, {}};
  grid.cells.assign(300 * 200, Cell::kFree);
  EXPECT_EQ(near_obstacles(grid).cells, grid.cells);  // The grid has no obstacles.
  grid.cells[100 * 300 + 150] = Cell::kOccupied;
  const Grid near = near_obstacles(grid);
  EXPECT_EQ(near.at(150, 100), Cell::kOccupied);
  EXPECT_EQ(near.at(200, 100), Cell::kFree);
  EXPECT_EQ(near.at(201, 100), Cell::kUnknown);
  EXPECT_EQ(near.at(150, 50), Cell::kFree);
  EXPECT_EQ(near.at(0, 0), Cell::kUnknown);
}

TEST(OpenGround, LeavesWhatStandsBesideThePlane) {
  WorldSpec world = wall();
  EXPECT_FALSE(extend_over(plane(10.0, 10.0), world));
  EXPECT_EQ(world.min_corner, Eigen::Vector2d(-5.0, -5.0));
  EXPECT_EQ(world.max_corner, Eigen::Vector2d(30.5, 5.0));
}

}  // namespace
}  // namespace castaway::sim
