#include "sim/people/walk_cells.hpp"

#include <gtest/gtest.h>

#include "sim/map/grid_tools.hpp"
#include "tests/sim/support/test_people.hpp"

namespace castaway::sim {
namespace {

class WalkCellsTest : public testing::Test {
 protected:
  TestHall hall_{6.0};
  std::shared_ptr<const WalkCells> cells_ = walk_cells(hall_.world, hall_.map);
};

TEST_F(WalkCellsTest, CoverTheWalkSpace) {
  ASSERT_FALSE(cells_->free().empty());
  EXPECT_GE(cells_->grid().resolution, WalkCells::kCell);
  for (const WalkCells::Index cell : cells_->free()) {
    EXPECT_TRUE(cells_->space().clear(cells_->center(cell)));
    EXPECT_EQ(cells_->near(cells_->center(cell)), cell);
  }
}

TEST_F(WalkCellsTest, StepsLeadToFreeNeighboursAndBack) {
  for (const WalkCells::Index cell : cells_->free()) {
    for (std::size_t step = 0; step < WalkCells::kSteps; ++step) {
      if (!cells_->has_exit(cell, step)) continue;
      const WalkCells::Index next = cells_->neighbour(cell, step);
      EXPECT_EQ(cells_->grid().cells[next], Cell::kFree);
      EXPECT_TRUE(cells_->has_exit(next, WalkCells::back(step)));
      EXPECT_EQ(cells_->neighbour(next, WalkCells::back(step)), cell);
      const double length = (cells_->center(next) - cells_->center(cell)).norm();
      const double edge = cells_->grid().resolution;
      EXPECT_NEAR(length, WalkCells::is_diagonal(step) ? std::sqrt(2.0) * edge : edge, 1e-9);
    }
  }
}

TEST_F(WalkCellsTest, CostMoreBesideWalls) {
  const double edge = cells_->grid().resolution;
  EXPECT_FLOAT_EQ(cells_->price(cells_->near({0.0, 0.0})), static_cast<float>(edge));
  const float beside = cells_->price(cells_->near({2.7, 0.0}));
  EXPECT_GT(beside, 2.0 * edge);
  EXPECT_LE(beside, (1.0 + WalkCells::kComfortWeight) * edge * 1.0001);
}

TEST_F(WalkCellsTest, AreNowhereFarOutside) {
  EXPECT_EQ(cells_->near({50.0, 0.0}), WalkCells::kNowhere);
}

}  // namespace
}  // namespace castaway::sim
