#include "localization/map/chebyshev_field.hpp"

#include <algorithm>
#include <cstdlib>

#include <gtest/gtest.h>

#include "tests/support/string_map.hpp"

namespace castaway::localization {
namespace {

TEST(ChebyshevField, CountsDiagonalStepsAsOne) {
  const ChebyshevField field(test::string_map({".....", ".....", "..#..", ".....", "....."}, 0.1),
                             9);
  EXPECT_EQ(field.at(2, 2), 0);
  EXPECT_EQ(field.at(3, 3), 1);
  EXPECT_EQ(field.at(4, 3), 2);
  EXPECT_EQ(field.at(0, 4), 2);
  EXPECT_EQ(field.at(-1, 2), 3);
  EXPECT_EQ(field.at(2, 7), 5);
}

TEST(ChebyshevField, EqualsTheNaiveDoubleLoop) {
  constexpr int kCap = 6;
  Rng rng = substream(5, "maps");
  for (int round = 0; round < 20; ++round) {
    OccupancyGrid grid;
    grid.frame = {23, 17, 0.05, {}};
    for (std::size_t i = 0; i < grid.frame.size(); ++i) {
      grid.cells.push_back(rng() % 50 == 0 ? CellState::kOccupied : CellState::kFree);
    }
    const ChebyshevField field(grid, kCap);
    for (int r = -9; r < 17 + 9; ++r) {
      for (int c = -9; c < 23 + 9; ++c) {
        int best = kCap;
        for (int q = 0; q < 17; ++q) {
          for (int p = 0; p < 23; ++p) {
            if (grid.cells[grid.frame.index({p, q})] != CellState::kOccupied) continue;
            best = std::min(best, std::max(std::abs(c - p), std::abs(r - q)));
          }
        }
        ASSERT_EQ(field.at(c, r), best) << c << ", " << r;
      }
    }
  }
}

TEST(ChebyshevField, IsCappedWithoutWallsAndOffTheMap) {
  const ChebyshevField field(test::string_map({".. ", "..."}, 0.1), 255);
  EXPECT_EQ(field.at(1, 1), 255);
  EXPECT_EQ(field.at(-300, 1), 255);
  EXPECT_EQ(field.at(1 << 29, -(1 << 29)), 255);
}

}  // namespace
}  // namespace castaway::localization
