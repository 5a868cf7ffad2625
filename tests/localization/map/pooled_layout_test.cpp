#include "localization/map/pooled_field.hpp"

#include <gtest/gtest.h>

namespace castaway::localization {
namespace {

TEST(PooledLayout, CoversTheCellsWithTilesAndPadding) {
  const PooledLayout layout(20, 5, 3, 1);  // 10 x 3 nodes of 2 x 2 cells
  EXPECT_EQ(layout.edge, 2);
  EXPECT_EQ(layout.tile_columns, 2);
  EXPECT_EQ(layout.tile_rows, 2);
  EXPECT_EQ(layout.padding_columns, 2);
  EXPECT_EQ(layout.padding_rows, 1);
  EXPECT_EQ(layout.reach, 3);
  EXPECT_EQ(layout.stride, 2 * (16 + 2 * 2));
  EXPECT_EQ(layout.phase_size, 40 * (2 + 2 * 1));
  EXPECT_EQ(layout.phases(), 2 * 4);
}

TEST(PooledLayout, FindsTilesAfterThePadding) {
  const PooledLayout layout(20, 5, 3, 1);
  EXPECT_EQ(layout.tile_offset(0, 0), 40 + 2 * 2);
  EXPECT_EQ(layout.tile_offset(1, 1), (1 + 1) * 40 + 2 * (8 + 2));
  EXPECT_EQ(layout.tile_index(1, 1), 3U);
}

TEST(PooledLayout, ShiftsWithinAPhaseByWholeNodesAndTiles) {
  const PooledLayout layout(20, 5, 3, 1);  // A phase has 160 bytes.
  EXPECT_EQ(layout.shift(0, 0), 0);
  EXPECT_EQ(layout.shift(2, 0), 2);
  EXPECT_EQ(layout.shift(0, 4), 40);
  EXPECT_EQ(layout.shift(1, 0), 160);
  EXPECT_EQ(layout.shift(0, 1), 2 * 160);
  EXPECT_EQ(layout.shift(0, 2), 4 * 160);
  EXPECT_EQ(layout.shift(-1, 0), 160 - 2);
  EXPECT_EQ(layout.shift(-2, -1), 6 * 160 - 40 - 2);
  EXPECT_EQ(PooledLayout(20, 5, 3, 0).shift(-2, 1), 2 * 30 * (3 + 2 * 2) - 2 * 2);
}

}  // namespace
}  // namespace castaway::localization
