#include "localization/map/pooled_field.hpp"

#include <gtest/gtest.h>

#include "tests/localization/matching/search_case.hpp"
#include "tests/support/string_map.hpp"

namespace castaway::localization {
namespace {

int naive_best(const ByteField& field, int column, int row, int edge) {
  int best = 0;
  for (int y = row; y < row + edge; ++y) {
    for (int x = column; x < column + edge; ++x) {
      best = std::max(best, test::byte_at(field, x, y));
    }
  }
  return best;
}

TEST(PooledField, HoldsTheDeficitOfEveryShiftedSquare) {
  Rng rng = substream(1, "pooled_field");
  const OccupancyGrid grid = test::random_room(rng);
  const ByteField field(grid, DistanceField(grid, 5.0), {0.2, 0.15, 3.0});
  for (int level = 0; level < 5; ++level) {
    const PooledField pooled(field, level);
    const int edge = 1 << level;
    EXPECT_EQ(pooled.layout().edge, edge);
    EXPECT_EQ(pooled.step(), level == 0 ? 1 : 17);
    for (int k = 0; k < 20000; ++k) {
      const auto between = [&](int low, int high) {
        return low + static_cast<int>(rng() % static_cast<unsigned>(high - low + 1));
      };
      const int column = between(0, pooled.layout().tile_columns - 1);
      const int row = between(0, pooled.layout().tile_rows - 1);
      const int j = between(0, 7);
      const int r = between(0, 1);
      const int dx = between(1 - pooled.layout().reach, pooled.layout().reach - 1);
      const int dy = between(1 - pooled.layout().reach, pooled.layout().reach - 1);
      const int deficit = pooled.tile(column, row)[2 * j + r + pooled.layout().shift(dx, dy)];
      const int best =
          naive_best(field, (8 * column + j) * edge + dx, (2 * row + r) * edge + dy, edge);
      ASSERT_EQ(deficit, (255 - best) / pooled.step());
    }
  }
}

TEST(PooledField, KnowsWhichNodesCoverFreeCells) {
  const OccupancyGrid grid = test::string_map({"#########.", "##########", "####.#####"}, 0.2);
  const ByteField field(grid, DistanceField(grid, 5.0), {0.2, 0.15, 1.0});
  const PooledField cells(field, 0);
  EXPECT_EQ(cells.layout().tile_columns, 2);
  EXPECT_EQ(cells.layout().tile_rows, 2);
  EXPECT_EQ(cells.free_nodes(0, 0), 1U << 4U);
  EXPECT_EQ(cells.free_nodes(1, 0), 0U);
  EXPECT_EQ(cells.free_nodes(1, 1), 1U << 1U);
  const PooledField coarse(field, 1);
  EXPECT_EQ(coarse.layout().tile_columns, 1);
  EXPECT_EQ(coarse.free_nodes(0, 0), 1U << 2U | 1U << 12U);
}

TEST(PooledField, TakesOtherFreeCells) {
  const OccupancyGrid grid = test::string_map({"#########.", "##########", "####.#####"}, 0.2);
  const ByteField field(grid, DistanceField(grid, 5.0), {0.2, 0.15, 1.0});
  const PooledField cells(field, 0);
  const std::vector<Eigen::Vector2i> free{{1, 0}, {9, 2}};
  const PooledField other = cells.with_free(free);
  EXPECT_EQ(other.free_nodes(0, 0), 1U << 1U);
  EXPECT_EQ(other.free_nodes(1, 1), 1U << 1U);
  EXPECT_EQ(other.tile(0, 0), cells.tile(0, 0));
  EXPECT_EQ(PooledField(field, 1).with_free(free).free_nodes(0, 0), 1U << 0U | 1U << 12U);
}

}  // namespace
}  // namespace castaway::localization
