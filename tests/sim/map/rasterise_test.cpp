#include "sim/map/rasterise.hpp"

#include <algorithm>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "sim/map/grid_tools.hpp"
#include "sim/world/slice.hpp"
#include "tests/sim/support/test_world.hpp"

namespace castaway::sim {
namespace {

WorldSpec world_with(const WorldObject& object) {
  WorldSpec world;
  world.name = "one";
  world.objects = {object};
  world.max_corner = {5.0, 4.0};
  return world;
}

TEST(Rasterise, CutsABoxAtTheHeight) {
  WorldSpec world = world_with(box_on_floor("box", {2.0, 1.0, 0.5}, {2.0, 1.5}));
  const std::vector<std::string> expected{".....",  //
                                          ".....",  //
                                          ".##..",  //
                                          "....."};
  EXPECT_EQ(art_of(rasterise(world, 0.2, 1.0)), expected);
  EXPECT_EQ(art_of(rasterise(world, 0.6, 1.0))[2], ".....");
  world.objects[0].in_map = false;
  EXPECT_EQ(art_of(rasterise(world, 0.2, 1.0))[2], ".....");
}

TEST(Rasterise, MarksCellsThatAreCutInPart) {
  const WorldSpec world = world_with(box_on_floor("box", {1.0, 1.0, 0.5}, {2.4, 1.6}));
  EXPECT_EQ(art_of(rasterise(world, 0.2, 1.0)), (std::vector<std::string>{".....",  //
                                                                          ".##..",  //
                                                                          ".##..",  //
                                                                          "....."}));
}

TEST(Rasterise, CutsATurnedBoxToADiamond) {
  // A square of 2 m standing on its corner at (2.5, 2); half its diagonal is 1.414 m. It separates
  // the right side.
  const WorldSpec world =
      world_with(box_on_floor("box", {2.0, 2.0, 0.5}, {2.5, 2.0}, 0.7853981633974483));
  EXPECT_EQ(art_of(rasterise(world, 0.2, 1.0)), (std::vector<std::string>{"..#??",  //
                                                                          ".###?",  //
                                                                          ".###?",  //
                                                                          "..#??"}));
}

TEST(Rasterise, CutsACylinderToADisc) {
  WorldObject pillar;
  pillar.shape = CylinderShape{0.9, 1.0};
  pillar.T_map_object = Eigen::Translation3d(2.5, 1.5, 0.5);
  EXPECT_EQ(art_of(rasterise(world_with(pillar), 0.2, 1.0)),
            (std::vector<std::string>{".....",  //
                                      ".###.",  //
                                      ".###.",  //
                                      ".###."}));
}

TEST(Rasterise, CutsALyingCylinderToItsWidthAtTheHeight) {
  // Axis along x at height 0.5, radius 0.5: at height 0.9 it is 0.6 m wide.
  WorldObject log;
  log.shape = CylinderShape{0.5, 3.0};
  log.T_map_object = Eigen::Translation3d(2.5, 2.0, 0.5) *
                     Eigen::AngleAxisd(1.5707963267948966, Eigen::Vector3d::UnitY());
  const Grid grid = rasterise(world_with(log), 0.9, 0.1);
  int width = 0;
  for (int row = 0; row < grid.height; ++row) width += grid.at(25, row) == Cell::kOccupied ? 1 : 0;
  EXPECT_EQ(width, 6);
}

TEST(Rasterise, OutlinesAMesh) {
  WorldObject cube;
  cube.shape = MeshShape{CASTAWAY_TEST_DATA "/meshes/cube.obj", {2.8, 2.8, 1.0}};
  cube.T_map_object = Eigen::Translation3d(2.5, 1.5, 0.5);
  EXPECT_EQ(art_of(rasterise(world_with(cube), 0.3, 1.0)),
            (std::vector<std::string>{".....",  //
                                      ".###.",  //
                                      ".#?#.",  //
                                      ".###."}));
}

int occupied(const Grid& grid) {
  return static_cast<int>(std::count(grid.cells.begin(), grid.cells.end(), Cell::kOccupied));
}

/// A cube of four cells, in a mesh, has faces on five columns and rows. The quotients of these
/// round numbers lie on both sides of whole ones.
TEST(Rasterise, ShowsASurfaceOnAnEdgeInTheCellAbove) {
  WorldObject cube;
  cube.shape = MeshShape{CASTAWAY_TEST_DATA "/meshes/cube.obj", {0.2, 0.2, 1.0}};
  for (int i = 0; i < 60; ++i) {
    cube.T_map_object = Eigen::Translation3d(-3.0 + 0.05 * i, -2.0 + 0.05 * i, 0.5);
    WorldSpec world = world_with(cube);
    world.min_corner = {-4.05, -3.05};
    const Grid grid = cut_world(world, 0.3, 0.05);
    EXPECT_EQ(occupied(grid), 16) << i;
    EXPECT_EQ(cell_at(grid, {-3.0 + 0.05 * i + 0.125, -2.0 + 0.05 * i + 0.125}), Cell::kOccupied)
        << i;
  }
}

TEST(Rasterise, ShowsASurfaceOnTheMapsEdgeInTheLastCell) {
  WorldObject cube;
  cube.shape = MeshShape{CASTAWAY_TEST_DATA "/meshes/cube.obj", {2.0, 2.0, 1.0}};
  cube.T_map_object = Eigen::Translation3d(4.0, 3.0, 0.5);
  EXPECT_EQ(art_of(cut_world(world_with(cube), 0.3, 1.0)),
            (std::vector<std::string>{"...##",  //
                                      "...##",  //
                                      ".....",  //
                                      "....."}));
}

TEST(Rasterise, ShowsSolidsThatAreThinnerThanRounding) {
  WorldSpec world = world_with(box_on_floor("sheet", {2.0, 1e-9, 0.5}, {2.5, 1.0}));
  EXPECT_EQ(occupied(cut_world(world, 0.2, 1.0)), 3);
  world.objects[0].shape = BoxShape{{1e-9, 2.0, 0.5}};
  world.objects[0].T_map_object.translation() = Eigen::Vector3d(3.0 - 1e-7, 1.5, 0.25);
  EXPECT_EQ(occupied(cut_world(world, 0.2, 1.0)), 3);
  world.objects[0].shape = CylinderShape{1e-9, 0.5};
  EXPECT_EQ(occupied(cut_world(world, 0.2, 1.0)), 1);
}

/// A face of a box is on the edge of the next cell, which stays free.
TEST(Rasterise, LeavesCellsFreeThatASolidOnlyTouches) {
  for (int i = 0; i < 60; ++i) {
    WorldSpec world =
        world_with(box_on_floor("box", {0.2, 0.1, 0.5}, {-3.0 + 0.05 * i, -2.0 + 0.05 * i}));
    world.min_corner = {-4.05, -3.05};
    EXPECT_EQ(occupied(cut_world(world, 0.3, 0.05)), 8) << i;
  }
}

TEST(Slices, AreThoseOfEachHeight) {
  WorldObject cube;
  cube.name = "cube";
  cube.shape = MeshShape{CASTAWAY_TEST_DATA "/meshes/cube.obj", {2.8, 2.8, 1.0}};
  const std::vector<double> heights{0.1, 0.4, 9.0};
  for (const WorldObject& object : {cube, box_on_floor("box", {1.0, 2.0, 0.3}, {0.0, 0.0})}) {
    const auto all = slices(object, heights);
    ASSERT_EQ(all.size(), heights.size());
    for (std::size_t i = 0; i < heights.size(); ++i) {
      const Slice one = slice(object, heights[i]);
      EXPECT_EQ(all[i].outlines.size(), one.outlines.size());
      ASSERT_EQ(all[i].segments.size(), one.segments.size());
      for (std::size_t k = 0; k < one.segments.size(); ++k) {
        EXPECT_EQ(all[i].segments[k].a, one.segments[k].a);
      }
    }
  }
}

TEST(Rasterise, LeavesTheOutsideUnknown) {
  const Grid grid = rasterise(test_room(), 0.2, 0.05);
  EXPECT_EQ(cell_at(grid, {0.0, -2.0}), Cell::kFree);
  EXPECT_EQ(cell_at(grid, {-2.0, -1.2}), Cell::kOccupied);
  EXPECT_EQ(cell_at(grid, {4.05, 0.0}), Cell::kOccupied);
}

TEST(Rasterise, MarksObjectsThatAreNotOnTheMap) {
  WorldSpec world = test_room();
  Grid grid = rasterise(world, 0.2, 0.05);
  WorldObject crate = box_on_floor("crate", {0.4, 0.4, 0.1}, {0.0, -2.0});
  crate.in_map = false;
  world.objects.push_back(crate);
  mark_objects(grid, world, {0.05});
  EXPECT_EQ(cell_at(grid, {0.0, -2.0}), Cell::kOccupied);
}

TEST(Rasterise, RefusesAWorldWithoutExtent) {
  EXPECT_THROW(rasterise(WorldSpec{}, 0.2, 0.05), std::invalid_argument);
}

}  // namespace
}  // namespace castaway::sim
