#include "localization/map/wall_clearance.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/string_map.hpp"

namespace castaway::localization {
namespace {

TEST(WallClearance, IsTheDistanceRoundedDownToHalfCells) {
  const OccupancyGrid grid = test::string_map({"#....", ".....", "....."}, 0.05);  // Top row first.
  const WallClearance walls(DistanceField(grid, 5.0));
  EXPECT_EQ(walls.half_cells(0, 2), 0);
  EXPECT_EQ(walls.half_cells(1, 2), 2);
  EXPECT_EQ(walls.half_cells(3, 2), 6);
  EXPECT_EQ(walls.half_cells(1, 1), 2);  // sqrt(2) cells
  EXPECT_EQ(walls.half_cells(3, 0), 7);  // sqrt(13) cells
}

TEST(WallClearance, NeverExceedsTheDistance) {
  std::string row(400, '.');
  row[0] = '#';
  for (const double resolution : {0.02, 0.05, 0.1}) {
    const DistanceField distances(test::string_map({row, row}, resolution), 50.0);
    const WallClearance walls(distances);
    for (int c = 0; c < 400; ++c) EXPECT_EQ(walls.half_cells(c, 1), std::min(2 * c, 255));
  }
}

}  // namespace
}  // namespace castaway::localization
