#include "localization/map/pooled_layout.hpp"

#include <gtest/gtest.h>

namespace castaway::localization {
namespace {

TEST(PooledLayout, CoversTheCellsWithTilesAndPadding) {
  const PooledLayout layout(20, 5, 3, 2);  // 10 x 3 nodes
  EXPECT_EQ(layout.tile_columns, 2);
  EXPECT_EQ(layout.tile_rows, 2);
  EXPECT_EQ(layout.padding_nodes, 2);
  EXPECT_EQ(layout.reach, 3);
  EXPECT_EQ(layout.stride, 16 + 2 * 2);
  EXPECT_EQ(layout.phase_size, 20 * (4 + 2 * 2));
}

TEST(PooledLayout, FindsTilesAfterThePadding) {
  const PooledLayout layout(20, 5, 3, 2);
  EXPECT_EQ(layout.tile_offset(0, 0), 2 * 20 + 2);
  EXPECT_EQ(layout.tile_offset(1, 1), (2 + 2) * 20 + 8 + 2);
  EXPECT_EQ(layout.tile_index(1, 1), 3U);
}

TEST(PooledLayout, ShiftsWithinAPhaseByWholeNodes) {
  const PooledLayout layout(20, 5, 3, 2);  // A phase has 160 bytes.
  EXPECT_EQ(layout.shift(0, 0), 0);
  EXPECT_EQ(layout.shift(2, 0), 1);
  EXPECT_EQ(layout.shift(0, 2), 20);
  EXPECT_EQ(layout.shift(1, 0), 160);
  EXPECT_EQ(layout.shift(0, 1), 2 * 160);
  EXPECT_EQ(layout.shift(-1, 0), 160 - 1);
  EXPECT_EQ(layout.shift(-2, -1), 2 * 160 - 20 - 1);
  EXPECT_EQ(PooledLayout(20, 5, 3, 1).shift(-2, 1), 30 - 2);
}

}  // namespace
}  // namespace castaway::localization
