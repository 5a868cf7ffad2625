#include "localization/map/coarsen.hpp"

#include <gtest/gtest.h>

#include "tests/support/string_map.hpp"

namespace castaway::localization {
namespace {

TEST(Coarsened, KeepsWallsThenFreeSpace) {
  const OccupancyGrid coarse =
      coarsen(test::string_map({"..  ", ".#  ", "... ", "..  "}, 0.1, {1, 2, 0.3}), 2);
  EXPECT_EQ(coarse.frame.width, 2);
  EXPECT_DOUBLE_EQ(coarse.frame.resolution, 0.2);
  EXPECT_EQ(coarse.frame.T_map_grid, (SE2{1, 2, 0.3}));
  EXPECT_EQ(coarse.cells[coarse.frame.index({0, 1})], CellState::kOccupied);
  EXPECT_EQ(coarse.cells[coarse.frame.index({0, 0})], CellState::kFree);
  EXPECT_EQ(coarse.cells[coarse.frame.index({1, 0})], CellState::kFree);
  EXPECT_EQ(coarse.cells[coarse.frame.index({1, 1})], CellState::kUnknown);
}

TEST(Coarsened, RoundsItsSizeUp) {
  EXPECT_EQ(coarsen(test::string_map({"....."}, 0.1), 4).frame.width, 2);
}

}  // namespace
}  // namespace castaway::localization
