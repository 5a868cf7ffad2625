#include "localization/map/distance_field.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/string_map.hpp"

namespace castaway::localization {
namespace {

TEST(DistanceField, IsExactOnASmallMap) {
  const OccupancyGrid grid = test::string_map({".....", ".....", "..#..", ".....", "....."}, 0.1);
  const DistanceField field(grid, 5.0);
  EXPECT_FLOAT_EQ(field.values()[grid.frame.index({2, 2})], 0.0F);
  EXPECT_FLOAT_EQ(field.values()[grid.frame.index({4, 2})], 0.2F);
  EXPECT_FLOAT_EQ(field.values()[grid.frame.index({3, 3})], 0.1F * std::sqrt(2.0F));
  EXPECT_FLOAT_EQ(field.values()[grid.frame.index({0, 4})], 0.1F * std::sqrt(8.0F));
}

TEST(DistanceField, EqualsTheNaiveDoubleLoop) {
  Rng rng = substream(5, "maps");
  for (int round = 0; round < 20; ++round) {
    OccupancyGrid grid;
    grid.frame = {23, 17, 0.05, {}};
    for (std::size_t i = 0; i < grid.frame.size(); ++i) {
      grid.cells.push_back(rng() % 20 == 0 ? CellState::kOccupied : CellState::kFree);
    }
    grid.cells[0] = CellState::kOccupied;
    const DistanceField field(grid, 100.0);
    for (int r = 0; r < 17; ++r) {
      for (int c = 0; c < 23; ++c) {
        double best = 1e9;
        for (int q = 0; q < 17; ++q) {
          for (int p = 0; p < 23; ++p) {
            if (grid.cells[grid.frame.index({p, q})] != CellState::kOccupied) continue;
            best = std::min(best, 0.05 * std::hypot(c - p, r - q));
          }
        }
        ASSERT_NEAR(field.values()[grid.frame.index({c, r})], best, 1e-6);
      }
    }
  }
}

TEST(DistanceField, IsCappedWithoutWallsAndOffTheMap) {
  const OccupancyGrid grid = test::string_map({"...", "..."}, 0.1);
  const DistanceField field(grid, 2.0);
  EXPECT_DOUBLE_EQ(field.at({0.05, 0.05}), 2.0);
  EXPECT_DOUBLE_EQ(field.at({-1.0, 0.05}), 2.0);
}

}  // namespace
}  // namespace castaway::localization
