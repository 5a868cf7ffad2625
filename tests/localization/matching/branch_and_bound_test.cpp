#include "localization/matching/branch_and_bound.hpp"

#include <gtest/gtest.h>

#include "localization/matching/cascade_matcher.hpp"
#include "tests/localization/matching/search_case.hpp"

namespace castaway::localization {
namespace {

constexpr std::int64_t kUnlimited = 1'000'000'000;

struct Lists {
  std::vector<Place> exhaustive, bounded;
};

/// Searches for the best `count` places of one scan with both algorithms.
Lists search(const test::SearchedMap& map, const ScanPoints& points, int count,
             const std::optional<MatchWindow>& window = {}) {
  const SearchSpace space = map.space(window);
  const auto scans = map.rotate_scans(points, space);
  BestPlaces best = map.best_places(count);
  score_all(map.pyramid[0], space, scans, best);
  BranchAndBound search(map.pyramid, space, scans, map.best_places(count));
  EXPECT_TRUE(search.step(kUnlimited));
  return {best.list(), search.best().list()};
}

TEST(BranchAndBound, ListsWhatTheExhaustiveSearchLists) {
  Rng rng = substream(1, "branch_and_bound");
  int same = 0;
  for (int room = 0; room < 50; ++room) {
    const OccupancyGrid grid = test::random_room(rng);
    const test::SearchedMap map(grid, 1 + room % 4);
    const FreeSpace space(grid);
    for (int round = 0; round < 20; ++round) {
      const ScanPoints points = test::scan_from(grid, space.sample(rng), 24);
      const Lists lists = search(map, points, 1 + round);
      ASSERT_FALSE(lists.exhaustive.empty());
      same += lists.exhaustive == lists.bounded ? 1 : 0;
    }
  }
  EXPECT_EQ(same, 1000);
}

TEST(BranchAndBound, ListsTheSameWithinWindows) {
  Rng rng = substream(2, "branch_and_bound");
  for (int room = 0; room < 20; ++room) {
    OccupancyGrid grid = test::random_room(rng);
    const SE2 pose = FreeSpace(grid).sample(rng);
    const ScanPoints points = test::scan_from(grid, pose, 24);
    grid.frame.T_map_grid = {-3.0, 2.0, 0.7};
    const test::SearchedMap map(grid);
    const MatchWindow window{grid.frame.T_map_grid * pose, test::uniform(0.1, 2.0, rng), 0.8};
    const Lists lists = search(map, points, 10, window);
    EXPECT_FALSE(lists.exhaustive.empty());
    EXPECT_EQ(lists.exhaustive, lists.bounded);
  }
}

TEST(BranchAndBound, ListsTheSameWhereEverythingTies) {
  OccupancyGrid grid;
  grid.frame = {40, 40, 0.2, {}};
  grid.cells.assign(grid.frame.size(), CellState::kFree);
  for (std::size_t i = 0; i < grid.cells.size(); i += 4) grid.cells[i] = CellState::kOccupied;
  const test::SearchedMap map(grid);
  ScanPoints points;
  points.x = {0.4F, -0.8F};
  points.y = {0.0F, 0.0F};
  const Lists lists = search(map, points, 30);
  EXPECT_EQ(lists.exhaustive.size(), 30U);
  EXPECT_EQ(lists.exhaustive.front().score, lists.exhaustive.back().score);
  EXPECT_EQ(lists.exhaustive, lists.bounded);
}

/// Highest score of the free cells in a node.
int best_below(const test::SearchedMap& map, const std::vector<CellOffset>& scan, int column,
               int row, int edge) {
  int best = 0;
  for (int y = row; y < std::min(row + edge, map.field.frame().height); ++y) {
    for (int x = column; x < std::min(column + edge, map.field.frame().width); ++x) {
      if (map.field.is_free(x, y)) best = std::max(best, test::naive_score(map.field, scan, x, y));
    }
  }
  return best;
}

TEST(BranchAndBound, BoundsAreAdmissibleAtEveryLevel) {
  Rng rng = substream(3, "branch_and_bound");
  const OccupancyGrid grid = test::random_room(rng);
  const test::SearchedMap map(grid, 5);
  const SearchSpace space = map.space();
  const auto scans =
      map.rotate_scans(test::scan_from(grid, FreeSpace(grid).sample(rng), 24), space);
  ScanShifts shifts(map.pyramid.size(), scans);
  for (const PooledField& level : map.pyramid) {
    for (std::size_t yaw = 0; yaw < scans.size(); yaw += 7) {
      for (int k = 0; k < level.layout().tile_columns * level.layout().tile_rows; ++k) {
        const Tile tile{k % level.layout().tile_columns, k / level.layout().tile_columns, 0};
        const TileSums bounds = tile_sums(level, tile, shifts.at(level.layout(), yaw)).sums;
        for (int j = 0; j < 16; ++j) {
          const int column = (8 * tile.column + j % 8) * level.layout().edge;
          const int row = (2 * tile.row + j / 8) * level.layout().edge;
          ASSERT_GE(bounds[static_cast<std::size_t>(j)],
                    best_below(map, scans[yaw], column, row, level.layout().edge));
        }
      }
    }
  }
}

TEST(BranchAndBound, CanBeStoppedAndGoneOnWith) {
  const OccupancyGrid grid = test::office();
  const test::SearchedMap map(grid);
  const SearchSpace space = map.space();
  const auto scans = map.rotate_scans(test::scan_from(grid, {3.0, 3.0, 0.4}, 24), space);
  BranchAndBound whole(map.pyramid, space, scans, map.best_places(20));
  EXPECT_FALSE(whole.complete());
  EXPECT_TRUE(whole.step(kUnlimited));
  EXPECT_TRUE(whole.complete());
  BranchAndBound sliced(map.pyramid, space, scans, map.best_places(20));
  int slices = 1;
  for (std::int64_t before = 0; !sliced.step(10); before = sliced.tiles_scored(), ++slices) {
    EXPECT_FALSE(sliced.complete());
    EXPECT_GE(sliced.tiles_scored(), before + 10);
    EXPECT_LT(sliced.tiles_scored(), before + 10 + 4 * 5);  // the tiles under one root
  }
  EXPECT_GT(slices, 10);
  EXPECT_EQ(sliced.best().list(), whole.best().list());
  EXPECT_EQ(sliced.tiles_scored(), whole.tiles_scored());
}

TEST(BranchAndBound, GivesTheBestSoFarWhenItsBudgetIsSpent) {
  const OccupancyGrid grid = test::office();
  const test::SearchedMap map(grid);
  const SearchSpace space = map.space();
  const auto scans = map.rotate_scans(test::scan_from(grid, {3.0, 3.0, 0.4}, 24), space);
  BranchAndBound search(map.pyramid, space, scans, map.best_places(20));
  EXPECT_FALSE(search.step(1));
  EXPECT_TRUE(search.best().list().empty());  // bounds only
  while (search.best().list().empty()) search.step(1);
  EXPECT_FALSE(search.complete());
  const int first = search.best().list().front().score;
  search.step(kUnlimited);
  EXPECT_GE(search.best().list().front().score, first);
}

TEST(BranchAndBound, ScoresAFractionOfTheTiles) {
  const OccupancyGrid grid = test::office();
  const test::SearchedMap map(grid);
  const SearchSpace space = map.space();
  const auto scans = map.rotate_scans(test::scan_from(grid, {3.0, 3.0, 0.4}, 24), space);
  BranchAndBound search(map.pyramid, space, scans, map.best_places(20));
  search.step(kUnlimited);
  EXPECT_LT(search.tiles_scored(), map.pyramid[0].layout().tile_columns *
                                       map.pyramid[0].layout().tile_rows *
                                       test::SearchedMap::kYaws / 2);
}

TEST(BranchAndBound, IsCompleteAtOnceWithoutFreeCellsOrPoints) {
  OccupancyGrid grid = test::office();
  const test::SearchedMap office(grid);
  EXPECT_TRUE(search(office, {}, 5).bounded.empty());
  grid.cells.assign(grid.cells.size(), CellState::kUnknown);
  const test::SearchedMap nowhere(grid);
  const ScanPoints points = test::scan_from(test::office(), {3.0, 3.0, 0.0}, 24);
  EXPECT_TRUE(search(nowhere, points, 5).bounded.empty());
}

}  // namespace
}  // namespace castaway::localization
