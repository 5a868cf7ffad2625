#include "sim/map/grid_tools.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <boost/random/uniform_int_distribution.hpp>

#include "sim/common/random.hpp"
#include "tests/sim/support/test_world.hpp"

namespace castaway::sim {
namespace {

TEST(GridTools, FindsCellsOfATurnedGrid) {
  Grid grid = make_grid(4, 3, 0.5, {1.0, 2.0}, Cell::kFree);
  grid.origin_yaw = std::numbers::pi / 2;
  const Eigen::Vector2d p = center_of(grid, {3, 0});  // Columns run along map's y, rows along -x.
  EXPECT_NEAR(p.x(), 0.75, 1e-12);
  EXPECT_NEAR(p.y(), 3.75, 1e-12);
  EXPECT_EQ(cell_of(grid, p), (CellIndex{3, 0}));
  EXPECT_EQ(cell_at(grid, {1.5, 2.5}), Cell::kUnknown);
}

TEST(GridTools, IndexesCellsRowByRow) {
  const Grid grid = grid_from_art({"..#",  //
                                   "..."});
  EXPECT_EQ(flat_index(grid, {2, 1}), 5U);
  EXPECT_EQ(cell_at_index(grid, 5), (CellIndex{2, 1}));
  EXPECT_FALSE(grid.is_free(2, 1));  // Row 0 is the lowest one.
  EXPECT_TRUE(grid.is_free(2, 0));
  EXPECT_FALSE(grid.is_free(3, 0));
}

TEST(GridTools, MeasuresDistancesByHand) {
  const Grid grid = grid_from_art({".......",  //
                                   ".......",  //
                                   "...#...",  //
                                   ".......",  //
                                   "......."});
  const std::vector<float> distance = distance_to_obstacle(grid);
  EXPECT_FLOAT_EQ(distance[flat_index(grid, {3, 2})], 0.0F);
  EXPECT_FLOAT_EQ(distance[flat_index(grid, {4, 3})], std::sqrt(2.0F));
  EXPECT_FLOAT_EQ(distance[flat_index(grid, {5, 2})], 2.0F);
  EXPECT_FLOAT_EQ(distance[flat_index(grid, {0, 0})], 1.0F);  // The border is closer.
}

TEST(GridTools, DistancesEqualThoseOfADoubleLoop) {
  Rng rng(1);
  boost::random::uniform_int_distribution<int> die(0, 19);
  Grid grid = make_grid(37, 23, 0.1, {0.0, 0.0}, Cell::kFree);
  for (Cell& cell : grid.cells) {
    const int roll = die(rng);
    if (roll < 2) cell = roll == 0 ? Cell::kOccupied : Cell::kUnknown;
  }
  const std::vector<float> distance = distance_to_obstacle(grid);
  for (int r = 0; r < grid.height; ++r) {
    for (int c = 0; c < grid.width; ++c) {
      double best = std::min({c + 1, r + 1, grid.width - c, grid.height - r});
      for (int y = 0; y < grid.height; ++y) {
        for (int x = 0; x < grid.width; ++x) {
          if (grid.at(x, y) != Cell::kFree) best = std::min(best, std::hypot(x - c, y - r));
        }
      }
      ASSERT_NEAR(distance[flat_index(grid, {c, r})], 0.1 * best, 1e-6);
    }
  }
}

TEST(GridTools, DistancesAreFarWhereNothingStands) {
  const Grid grid = make_grid(5, 4, 0.5, {0.0, 0.0}, Cell::kFree);
  for (const float distance : distance_to_obstacle(grid, GridEdge::kOpen)) {
    EXPECT_GT(distance, 1e5F);
  }
}

TEST(GridTools, ErodesOnTheSafeSide) {
  const Grid grid = grid_from_art({"#######",  //
                                   "#.....#",  //
                                   "#.....#",  //
                                   "#.....#",  //
                                   "#.....#",  //
                                   "#.....#",  //
                                   "#######"});
  EXPECT_EQ(art_of(erode(grid, 1.5)), (std::vector<std::string>{"#######",  //
                                                                "#######",  //
                                                                "##...##",  //
                                                                "##...##",  //
                                                                "##...##",  //
                                                                "#######",  //
                                                                "#######"}));
}

TEST(GridTools, KeepsTheLargestComponent) {
  const Grid grid = grid_from_art({"..#...",  //
                                   "..#...",  //
                                   "###...",  //
                                   ".?#..."});
  EXPECT_EQ(art_of(largest_component(grid)), (std::vector<std::string>{"??#...",  //
                                                                       "??#...",  //
                                                                       "###...",  //
                                                                       "??#..."}));
}

TEST(GridTools, DiagonalCellsAreNotConnected) {
  EXPECT_EQ(art_of(largest_component(grid_from_art({".#..",  //
                                                    "#.##"}))),
            (std::vector<std::string>{"?#..",  //
                                      "#?##"}));
}

TEST(GridTools, KeepsTheComponentOfAPoint) {
  const Grid grid = grid_from_art({"...#.",  //
                                   "...#.",  //
                                   "...##"});
  EXPECT_EQ(art_of(component_at(grid, {4.5, 2.5})), (std::vector<std::string>{"???#.",  //
                                                                              "???#.",  //
                                                                              "???##"}));
  EXPECT_EQ(art_of(component_at(grid, {3.5, 0.5})), art_of(largest_component(grid)));
}

}  // namespace
}  // namespace castaway::sim
