#include "localization/map/cell_index.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "localization/map/occupancy_grid.hpp"

namespace castaway::localization {
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

TEST(GridFrame, HasNoCellForAPointThatIsFarOut) {
  const GridFrame frame{5, 5, 0.05, {}};
  for (const double far : {1e12, 1e300, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_FALSE(frame.contains(frame.cell_of({far, 0.1})));
    EXPECT_FALSE(frame.contains(frame.cell_of({0.1, -far})));
  }
}

TEST(OccupancyGrid, IsRefusedWithCellsOfNoSensibleSize) {
  for (const double resolution : {1e-38, 1e-300, 1e12, 1e300, 0.0, -1.0}) {
    const OccupancyGrid grid{{2, 2, resolution, {}}, std::vector<CellState>(4)};
    EXPECT_THROW(validate(grid), std::invalid_argument) << resolution;
  }
}

}  // namespace
}  // namespace castaway::localization
