#include "localization/matching/tile_scorer.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/localization/matching/search_case.hpp"

namespace castaway::localization {
namespace {

TEST(Pyramid, DoublesTheEdgeAtEveryLevel) {
  Rng rng = substream(1, "tile_scorer");
  const test::SearchedMap map(test::random_room(rng), 3);
  ASSERT_EQ(map.pyramid.size(), 3U);
  EXPECT_EQ(map.pyramid[0].layout().edge, 1);
  EXPECT_EQ(map.pyramid[1].layout().edge, 2);
  EXPECT_EQ(map.pyramid[2].layout().edge, 4);
}

TEST(TileScorer, SumsTilesAndCountsTheirPoints) {
  Rng rng = substream(2, "tile_scorer");
  const OccupancyGrid grid = test::random_room(rng);
  const test::SearchedMap map(grid, 2);
  const auto scans =
      map.rotate_scans(test::scan_from(grid, FreeSpace(grid).sample(rng), 24), map.space());
  TileScorer scorer(map.pyramid, scans);
  EXPECT_EQ(scorer.top_level(), 1U);
  EXPECT_EQ(&scorer.level(1), &map.pyramid[1]);
  const Tile tile{0, 1, 7};
  for (const std::size_t level : {0U, 1U}) {
    const ScanShifts shifts(map.pyramid[level], scans);
    EXPECT_EQ(scorer.score(level, tile, 0), tile_sums(map.pyramid[level], tile, shifts.at(7)).sums);
  }
  EXPECT_EQ(scorer.scored(), static_cast<std::int64_t>(2 * scans[7].size()) / 64);
}

TEST(TileScorer, BoundsTheFreeNodesOfEachChild) {
  Rng rng = substream(3, "tile_scorer");
  const OccupancyGrid grid = test::random_room(rng);
  const test::SearchedMap map(grid, 2);
  const auto scans =
      map.rotate_scans(test::scan_from(grid, FreeSpace(grid).sample(rng), 24), map.space());
  TileScorer scorer(map.pyramid, scans);
  const PooledField& level = map.pyramid[1];
  for (int k = 0; k < level.layout().tile_columns * level.layout().tile_rows; ++k) {
    const Tile tile{k % level.layout().tile_columns, k / level.layout().tile_columns, 3};
    const TileSums sums = scorer.score(1, tile, 0);
    const BoundedTile bounded = scorer.bound(1, tile, 0);
    int best = 0;
    for (std::size_t child = 0; child < 4; ++child) {
      int expected = 0;
      for (std::size_t j = 4 * child; j < 4 * child + 4; ++j) {
        const bool free = (level.free_nodes(tile.column, tile.row) >> j & 1U) != 0;
        if (free) expected = std::max<int>(expected, sums[j]);
      }
      EXPECT_EQ(bounded.bounds[child], expected);
      best = std::max(best, expected);
    }
    EXPECT_EQ(bounded.bound(), best);
  }
}

}  // namespace
}  // namespace castaway::localization
