#include "sim/map/free_space.hpp"

#include <cmath>

#include <gtest/gtest.h>
#include <boost/random/uniform_int_distribution.hpp>

#include "tests/sim/support/test_world.hpp"

namespace castaway::sim {
namespace {

const std::vector<std::string> kTwoRooms{"############",  //
                                         "#.....#....#",  //
                                         "#.....#....#",  //
                                         "#.....#....#",  //
                                         "#.....#....#",  //
                                         "#.....#....#",  //
                                         "############"};

TEST(FreeSpace, IsWhereADiscFitsInTheLargestRoom) {
  const FreeSpace free(grid_from_art(kTwoRooms), 0.6);
  EXPECT_TRUE(free.contains({3.5, 3.5}));
  EXPECT_FALSE(free.contains({1.5, 3.5}));  // Too close to the wall.
  EXPECT_FALSE(free.contains({9.5, 3.5}));  // In the other room.
  EXPECT_FALSE(free.contains({-5.0, 3.5}));
}

TEST(FreeSpace, LeavesOutRoundObstacles) {
  const FreeSpace free(grid_from_art(std::vector<std::string>(9, ".........")), 0.6);
  const RoundObstacle pillar{{4.5, 4.5}, 1.0};
  const FreeSpace around = free.with_discs({&pillar, 1});
  EXPECT_FALSE(around.contains({4.5, 4.5}));
  EXPECT_FALSE(around.contains({4.5, 2.5}));  // The margin includes half a cell edge.
  EXPECT_TRUE(around.contains({4.5, 1.5}));
  EXPECT_NEAR(around.clearance_at({4.5, 2.5}), 1.0, 1e-6);
  EXPECT_NEAR(around.clearance_at({1.5, 1.5}), free.clearance_at({1.5, 1.5}), 1e-6);
  EXPECT_EQ(free.with_discs({}).grid().cells, free.grid().cells);
}

TEST(FreeSpace, KeepsTheLargerSideOfAnObstacle) {
  const FreeSpace free(grid_from_art({".........", ".........", "........."}), 0.1);
  const RoundObstacle plug{{6.5, 1.5}, 1.6};
  const FreeSpace around = free.with_discs({&plug, 1});
  EXPECT_TRUE(around.contains({2.5, 1.5}));
  EXPECT_FALSE(around.contains({8.5, 1.5}));
}

TEST(FreeSpace, SeesAlongSegments) {
  const FreeSpace free(grid_from_art({".....",  //
                                      "..#..",  //
                                      "....."}),
                       0.1);
  EXPECT_TRUE(free.contains_segment({0.5, 0.5}, {4.5, 0.5}));
  EXPECT_FALSE(free.contains_segment({0.5, 1.5}, {4.5, 1.5}));
}

TEST(FreeSpace, FindsTheNearestFreeCell) {
  const FreeSpace free(grid_from_art(kTwoRooms), 0.6);
  EXPECT_EQ(free.nearest_free({1.2, 3.4}), (CellIndex{2, 3}));
  EXPECT_EQ(free.nearest_free({3.5, 3.5}), (CellIndex{3, 3}));
  EXPECT_FALSE(FreeSpace(grid_from_art({"##", "##"}), 0.1).nearest_free({0.0, 0.0}).has_value());
}

TEST(FreeSpace, SamplesFarEnoughAway) {
  const FreeSpace free(grid_from_art(kTwoRooms), 0.1);
  Rng rng(1);
  for (int i = 0; i < 1000; ++i) {
    const auto pose = free.sample(rng, {1.5, 1.5}, 3.0);
    ASSERT_TRUE(pose.has_value());
    ASSERT_TRUE(free.contains(pose->position()));
    ASSERT_GE((pose->position() - Eigen::Vector2d(1.5, 1.5)).norm(), 3.0);
  }
  EXPECT_FALSE(free.sample(rng, {1.5, 1.5}, 100.0).has_value());
}

TEST(FreeSpace, SamplesUniformly) {
  const FreeSpace free(grid_from_art(kTwoRooms), 0.1);
  Rng rng(2);
  constexpr int kDraws = 20000;
  int left = 0;
  double cosine = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    const auto pose = free.sample(rng);
    left += pose->x < 3.5 ? 1 : 0;  // Half of the 5 x 5 free cells.
    cosine += std::cos(pose->yaw);
  }
  const double sigma = std::sqrt(0.25 / kDraws);
  EXPECT_NEAR(static_cast<double>(left) / kDraws, 0.5, 4.0 * sigma);
  EXPECT_NEAR(cosine / kDraws, 0.0, 4.0 * std::sqrt(0.5 / kDraws));
}

// Oracle: the cells in a list.
TEST(FreeSpace, SamplesTheCellsThatAreFarEnough) {
  Grid grid = grid_from_art(kTwoRooms, 0.1);
  grid.origin_yaw = 0.4;
  grid.origin = {2.0, -1.0};
  const FreeSpace free(grid, 0.06);
  for (unsigned seed = 0; seed < 200; ++seed) {
    const Eigen::Vector2d from = center_of(grid, {static_cast<int>(seed % 12), 3});
    const double least = 0.05 * (seed % 7);
    std::vector<std::size_t> cells;
    for (std::size_t i = 0; i < grid.cells.size(); ++i) {
      const double away = (center_of(grid, cell_at_index(grid, i)) - from).norm();
      const bool far = least <= 0.0 || away >= least + grid.resolution;
      if (free.grid().cells[i] == Cell::kFree && far) cells.push_back(i);
    }
    Rng rng(seed);
    Rng same(seed);
    const auto pose = free.sample(rng, from, least);
    ASSERT_EQ(pose.has_value(), !cells.empty());
    if (cells.empty()) continue;
    boost::random::uniform_int_distribution<std::size_t> any(0, cells.size() - 1);
    const CellIndex drawn = cell_at_index(grid, cells[any(same)]);
    EXPECT_EQ(cell_of(grid, pose->position()), drawn) << seed;
  }
}

TEST(FreeSpace, CopiesShareTheirCells) {
  const FreeSpace free(grid_from_art(kTwoRooms), 0.6);
  const FreeSpace copy = free;
  EXPECT_EQ(&copy.grid(), &free.grid());
}

}  // namespace
}  // namespace castaway::sim
