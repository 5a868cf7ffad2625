#include "localization/map/occupancy_grid.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/support/string_map.hpp"

namespace castaway::localization {
namespace {

TEST(GridFrame, FloorsToCellsAlsoBelowZero) {
  const GridFrame frame{4, 3, 0.5, {}};
  EXPECT_EQ(frame.cell_of({0.0, 0.0}), Eigen::Vector2i(0, 0));
  EXPECT_EQ(frame.cell_of({0.499, 1.0}), Eigen::Vector2i(0, 2));
  EXPECT_EQ(frame.cell_of({-0.01, -0.51}), Eigen::Vector2i(-1, -2));
  EXPECT_EQ(frame.centre_of({1, 2}), Eigen::Vector2d(0.75, 1.25));
  EXPECT_FALSE(frame.contains({4, 0}));
  EXPECT_FALSE(frame.contains({0, -1}));
}

TEST(OccupancyGrid, HonoursTheYawOfItsOrigin) {
  // Rotated by +90 deg about (10, 20): the grid's columns run along map's +y.
  const OccupancyGrid grid =
      test::string_map({"..#", "#.."}, 1.0, {10.0, 20.0, std::numbers::pi / 2});
  EXPECT_EQ(grid.at({9.5, 20.5}), CellState::kOccupied);  // column 0, row 0
  EXPECT_EQ(grid.at({8.5, 22.5}), CellState::kOccupied);  // column 2, row 1
  EXPECT_EQ(grid.at({9.5, 21.5}), CellState::kFree);
  EXPECT_EQ(grid.at({10.5, 20.5}), CellState::kUnknown);  // off the map
}

TEST(OccupancyGrid, RefusesWhatMakesNoSense) {
  OccupancyGrid grid = test::string_map({"..", ".."}, 1.0);
  EXPECT_NO_THROW(validate(grid));
  grid.cells.pop_back();
  EXPECT_THROW(validate(grid), std::invalid_argument);
  EXPECT_THROW(validate(OccupancyGrid{}), std::invalid_argument);
  grid = test::string_map({"."}, 0.0);
  EXPECT_THROW(validate(grid), std::invalid_argument);
}

TEST(FreeSpace, DrawsUniformlyOverFreeCellsOnly) {
  const OccupancyGrid grid = test::string_map({"#. ", "..#"}, 0.5, {1.0, 2.0, 0.3});
  const FreeSpace space(grid);
  Rng rng = substream(3, "free");
  constexpr int kCount = 6000;
  int first = 0;
  double yaw_sum = 0.0;
  for (int i = 0; i < kCount; ++i) {
    const SE2 pose = space.sample(rng);
    ASSERT_EQ(grid.at(pose.translation()), CellState::kFree);
    const Eigen::Vector2i cell =
        grid.frame.cell_of(grid.frame.T_map_grid.inverse() * pose.translation());
    if (cell == Eigen::Vector2i(0, 0)) ++first;
    yaw_sum += pose.yaw;
  }
  // Three free cells: binomial with p = 1/3; yaw uniform on [-pi, pi).
  EXPECT_NEAR(first, kCount / 3.0, 4 * std::sqrt(kCount * 2.0 / 9.0));
  EXPECT_NEAR(yaw_sum / kCount, 0.0, 4 * 1.82 / std::sqrt(kCount));
}

}  // namespace
}  // namespace castaway::localization
