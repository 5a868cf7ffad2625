#include "localization/matching/branch_and_bound.hpp"

#include <iterator>

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

TEST(TileScorer, SumsTilesAndCountsTheWork) {
  Rng rng = substream(2, "tile_scorer");
  const OccupancyGrid grid = test::random_room(rng);
  const test::SearchedMap map(grid, 2);
  const auto scans =
      map.rotate_scans(test::scan_from(grid, FreeSpace(grid).sample(rng), 24), map.space());
  TileScorer scorer(map.pyramid, scans);
  EXPECT_EQ(scorer.top_level(), 1U);
  EXPECT_EQ(&scorer.level(1), &map.pyramid[1]);
  const Tile tile{0, 1, 7};
  ScanShifts shifts(2, scans);
  const PooledField& cells = map.pyramid[0];
  const PooledField& coarse = map.pyramid[1];
  std::int64_t work = 0;
  for (int k = 0; k < 20; ++k, work += 5 * std::ssize(scans[7])) {
    EXPECT_EQ(scorer.scored(), work / (3 * 64));
    EXPECT_EQ(scorer.score(tile, 0), tile_sums(cells, tile, shifts.at(cells.layout(), 7)).sums);
    EXPECT_EQ(scorer.bound(1, tile, 0).children,
              tile_bounds(coarse, tile, shifts.at(coarse.layout(), 7)).children);
  }
}

TEST(BoundedTile, HasTheBestBoundOfItsChildren) {
  EXPECT_EQ((BoundedTile{{}, {3, 1, 9, 4}}).bound(), 9);
}

}  // namespace
}  // namespace castaway::localization
