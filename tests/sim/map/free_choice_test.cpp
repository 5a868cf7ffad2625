#include "sim/map/free_choice.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/sim/support/test_world.hpp"

namespace castaway::sim {
namespace {

using Reason = FreeChoice::Reason;

/// A house of two rooms surrounded by free space.
const std::vector<std::string> kHouse{"....................",  //
                                      "....................",  //
                                      "..###############...",  //
                                      "..#........#....#...",  //
                                      "..#........#....#...",  //
                                      "..#........#....#...",  //
                                      "..#........#....#...",  //
                                      "..###############...",  //
                                      "....................",  //
                                      "...................."};

TEST(ChooseFree, TakesTheLargestRoomNotTheOutside) {
  const FreeChoice choice = choose_free(grid_from_art(kHouse), 0.1, std::nullopt);
  EXPECT_EQ(choice.reason, Reason::kEnclosed);
  EXPECT_FALSE(choice.at_edge);
  EXPECT_EQ(art_of(choice.grid), (std::vector<std::string>{"????????????????????",  //
                                                           "????????????????????",  //
                                                           "??###############???",  //
                                                           "??#........#????#???",  //
                                                           "??#........#????#???",  //
                                                           "??#........#????#???",  //
                                                           "??#........#????#???",  //
                                                           "??###############???",  //
                                                           "????????????????????",  //
                                                           "????????????????????"}));
}

TEST(ChooseFree, TakesThePartThatTheStartLiesIn) {
  const FreeChoice small = choose_free(grid_from_art(kHouse), 0.1, Eigen::Vector2d(13.5, 4.5));
  EXPECT_EQ(small.reason, Reason::kStart);
  EXPECT_EQ(small.grid.at(13, 4), Cell::kFree);
  EXPECT_EQ(small.grid.at(5, 4), Cell::kUnknown);
  EXPECT_EQ(small.grid.at(0, 0), Cell::kUnknown);
  const FreeChoice outside = choose_free(grid_from_art(kHouse), 0.1, Eigen::Vector2d(0.5, 0.5));
  EXPECT_TRUE(outside.at_edge);
  EXPECT_EQ(outside.grid.at(0, 0), Cell::kFree);
}

TEST(ChooseFree, TakesTheNearestPartOfAStartBesideAWall) {
  const FreeChoice choice = choose_free(grid_from_art(kHouse), 0.6, Eigen::Vector2d(12.4, 3.4));
  EXPECT_EQ(choice.reason, Reason::kStart);
  EXPECT_EQ(choice.grid.at(13, 4), Cell::kFree);
}

/// The robot's size decides: gaps and openings that are too narrow for it separate regions.
TEST(ChooseFree, GoesByWhatTheRobotFitsThrough) {
  std::vector<std::string> leaky = kHouse;
  for (std::size_t row = 3; row < 7; ++row) leaky[row].replace(12, 4, "####");
  leaky[2] = "..######.########...";
  EXPECT_EQ(choose_free(grid_from_art(leaky), 0.6, std::nullopt).reason, Reason::kEnclosed);
  EXPECT_TRUE(choose_free(grid_from_art(leaky), 0.1, std::nullopt).at_edge);
}

/// A corridor that the image cuts off is not the outside.
TEST(ChooseFree, LeavesAMapThatIsCutOffAsItIs) {
  const Grid grid = grid_from_art({"##########",  //
                                   "..........",  //
                                   "..........",  //
                                   "####.#####",  //
                                   "#........#",  //
                                   "##########"});
  const FreeChoice choice = choose_free(grid, 0.1, std::nullopt);
  EXPECT_EQ(choice.reason, Reason::kOnly);
  EXPECT_TRUE(choice.at_edge);
  EXPECT_EQ(choice.grid.cells, grid.cells);
  EXPECT_FALSE(describe(choice).has_value());
}

TEST(ChooseFree, LeavesAMapWithUnknownOutsideAsItIs) {
  const Grid grid = grid_from_art({"??????????",  //
                                   "?########?",  //
                                   "?#......#?",  //
                                   "?#......#?",  //
                                   "?########?",  //
                                   "?????.????"});
  const FreeChoice choice = choose_free(grid, 0.1, std::nullopt);
  EXPECT_EQ(choice.grid.cells, grid.cells);
  EXPECT_NEAR(choice.area, 12.0, 1e-9);
}

TEST(ChooseFree, FallsBackToTheOpenWhereNothingIsEnclosed) {
  const Grid open = grid_from_art({".....", "..#..", "....."});
  EXPECT_EQ(choose_free(open, 0.1, std::nullopt).grid.cells, open.cells);
  const Grid full = grid_from_art({"###", "###"});
  EXPECT_EQ(choose_free(full, 0.1, std::nullopt).grid.cells, full.cells);
}

TEST(ChooseFree, SaysWhichPartWasTaken) {
  const auto enclosed = describe(choose_free(grid_from_art(kHouse), 0.1, std::nullopt));
  ASSERT_TRUE(enclosed.has_value());
  EXPECT_THAT(*enclosed, testing::HasSubstr("32 m2"));
  EXPECT_THAT(*enclosed, testing::HasSubstr("does not touch the map's edge"));
}

}  // namespace
}  // namespace castaway::sim
