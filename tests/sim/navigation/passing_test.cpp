#include "sim/navigation/passing.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "sim/world/grid_tools.hpp"

namespace castaway::sim {
namespace {

const Lane kLane{{0.0, 0.0}, {1.5, 0.0}};

/// A corridor along x with its middle at y = 0.
FreeSpace corridor(double half_width) {
  Grid grid;
  grid.resolution = 0.05;
  grid.width = 400;
  grid.height = 120;
  grid.origin = {-5.0, -3.0};
  grid.cells.assign(400 * 120, Cell::kFree);
  for (int row = 0; row < grid.height; ++row) {
    for (int column = 0; column < grid.width; ++column) {
      const double y = center_of(grid, {column, row}).y();
      if (std::abs(y) > half_width) grid.cells[flat_index(grid, {column, row})] = Cell::kOccupied;
    }
  }
  return FreeSpace(grid, 0.25);
}

Mover coming(double x, double y) { return {{x, y}, {-1.3, 0.0}}; }

TEST(Passing, KeepsToTheRightWhereThereIsRoom) {
  EXPECT_NEAR(Passing({}).aside(kLane, 0.8, {}, corridor(1.5)).y(), -0.4, 1e-9);
  EXPECT_NEAR(Passing({}).aside(kLane, 0.8, {}, corridor(0.5)).y(), 0.0, 1e-9);
}

TEST(Passing, LeavesRoomOnTheSideWhereThePersonIsNot) {
  const FreeSpace space = corridor(1.5);
  EXPECT_LT(Passing({}).aside(kLane, 0.8, {coming(4.0, 0.2)}, space).y(), -0.5);
  EXPECT_GT(Passing({}).aside(kLane, 0.8, {coming(4.0, -0.9)}, space).y(), -0.1);
}

TEST(Passing, DoesNotMindWhoIsBehindFarOffOrFaster) {
  const FreeSpace space = corridor(1.5);
  const std::vector<Mover> others{coming(-1.5, -0.4), coming(7.0, -0.4), {{2.0, -0.4}, {1.5, 0.0}}};
  EXPECT_NEAR(Passing({}).aside(kLane, 0.8, others, space).y(), -0.4, 1e-9);
}

TEST(Passing, ReachesTheLanesEnd) {
  const Lane end{{0.0, 0.0}, {0.5, 0.0}};
  EXPECT_EQ(Passing({}).aside(end, 0.8, {coming(2.0, 0.0)}, corridor(1.5)), end.to);
}

TEST(PassingPace, FallsAsAMoverComesNearer) {
  EXPECT_EQ(passing_pace(kLane, {}, 0.9), 0.9);
  EXPECT_EQ(passing_pace(kLane, {coming(5.0, 0.0)}, 0.9), 0.9);
  EXPECT_NEAR(passing_pace(kLane, {coming(3.0, 0.0)}, 0.9), 0.525, 1e-9);
  EXPECT_NEAR(passing_pace(kLane, {coming(1.0, 0.5)}, 0.9), 0.2, 1e-9);
}

TEST(PassingPace, IsFreeOfThoseBesideBehindAndAhead) {
  EXPECT_EQ(passing_pace(kLane, {coming(1.0, 1.4)}, 0.9), 0.9);
  EXPECT_EQ(passing_pace(kLane, {coming(-1.0, 0.0)}, 0.9), 0.9);
  EXPECT_EQ(passing_pace(kLane, {{{1.0, 0.0}, {1.4, 0.0}}}, 0.9), 0.9);
}

}  // namespace
}  // namespace castaway::sim
