#include "sim/common/cell_index.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "sim/map/grid_tools.hpp"

namespace castaway::sim {
namespace {

TEST(CellIndex, RoundsDown) {
  EXPECT_EQ(cell_index(0.0), 0);
  EXPECT_EQ(cell_index(2.999), 2);
  EXPECT_EQ(cell_index(-0.001), -1);
  EXPECT_EQ(cell_index(-3.0F), -3);
}

TEST(CellIndex, StaysWithinAnIntWhateverTheNumber) {
  const double inf = std::numeric_limits<double>::infinity();
  for (const double far : {1e9, 1e12, 1e300, inf}) {
    EXPECT_EQ(cell_index(far), kFarthestCell);
    EXPECT_EQ(cell_index(-far), -kFarthestCell);
    EXPECT_EQ(cell_index(static_cast<float>(far)), kFarthestCell);
  }
  EXPECT_EQ(cell_index(std::numeric_limits<double>::quiet_NaN()), kFarthestCell);
}

TEST(Grid, HasNoCellForAPointThatIsFarOut) {
  const Grid grid = make_grid(5, 5, 0.05, {0.0, 0.0}, Cell::kFree);
  for (const double far : {1e12, 1e300, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_EQ(cell_at(grid, {far, 0.1}), Cell::kUnknown);
    EXPECT_EQ(cell_at(grid, {0.1, -far}), Cell::kUnknown);
  }
}

}  // namespace
}  // namespace castaway::sim
