#include "localization/matching/tiles.hpp"

#include <gtest/gtest.h>

#include "tests/support/string_map.hpp"

namespace castaway::localization {
namespace {

/// 20 x 5 cells of 20 cm; free are (1, 0), (12, 3) and (18, 4).
ByteField three_free_cells() {
  const OccupancyGrid grid =
      test::string_map({"##################.#", "############.#######", "####################",
                        "####################", "#.##################"},
                       0.2);
  return {grid, DistanceField(grid, 5.0), {0.2, 0.15, 1.0}};
}

TEST(Tiles, AreThoseWithFreeCellsInTheSpace) {
  const PooledField cells(three_free_cells(), 0);
  SearchSpace space{{0, 0}, {19, 4}, {0}};
  const std::vector<Tile> all = tiles_within(cells, space);
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[1].column, 1);
  EXPECT_EQ(all[1].row, 1);
  space.low = {16, 0};
  EXPECT_EQ(tiles_within(cells, space).size(), 1U);
  space = {{0, 0}, {15, 1}, {0}};
  EXPECT_EQ(tiles_within(cells, space).size(), 1U);
}

TEST(Tiles, OfferTheirFreeCellsInTheSpace) {
  const ByteField field = three_free_cells();
  const PooledField cells(field, 0);
  SearchSpace space{{0, 0}, {19, 4}, {7}};
  TileSums scores{};
  scores.fill(9);
  scores[12] = 5;  // cell (12, 3)
  BestPlaces best(field.frame(), {4, 3}, 5, 100);
  offer_tile(cells, space, {1, 1, 0}, scores, best);
  EXPECT_EQ(best.list(), (std::vector<Place>{{12, 3, 7, 5}}));
  BestPlaces none(field.frame(), {4, 3}, 5, 100);
  space.high.x() = 11;
  offer_tile(cells, space, {1, 1, 0}, scores, none);
  EXPECT_TRUE(none.list().empty());
}

}  // namespace
}  // namespace castaway::localization
