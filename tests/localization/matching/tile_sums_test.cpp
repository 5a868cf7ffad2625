#include "localization/matching/tile_sums.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "localization/matching/scan_shifts.hpp"
#include "tests/localization/matching/search_case.hpp"

namespace castaway::localization {
namespace {

TEST(TileSums, EqualTheNaiveLoop) {
  Rng rng = substream(1, "tile_sums");
  const OccupancyGrid grid = test::random_room(rng);
  const test::SearchedMap map(grid);
  const SearchSpace space = map.space();
  const auto scans = map.rotate_scans(test::scan_from(grid, {1.5, 1.0, 0.3}, 24), space);
  ScanShifts shifts(1, scans);
  for (std::size_t yaw = 0; yaw < scans.size(); ++yaw) {
    const Tile tile{static_cast<int>(yaw) % map.pyramid[0].layout().tile_columns,
                    static_cast<int>(yaw) % map.pyramid[0].layout().tile_rows,
                    static_cast<int>(yaw)};
    const TileSums sums =
        tile_sums(map.pyramid[0], tile, shifts.at(map.pyramid[0].layout(), yaw)).sums;
    for (int j = 0; j < 16; ++j) {
      EXPECT_EQ(
          sums[static_cast<std::size_t>(j)],
          test::naive_score(map.field, scans[yaw], 8 * tile.column + j % 8, 2 * tile.row + j / 8));
    }
  }
}

TEST(TileSums, StopEarlyOnlyWhereNoNodeReachesTheLeast) {
  Rng rng = substream(2, "tile_sums");
  const OccupancyGrid grid = test::random_room(rng);
  const test::SearchedMap map(grid);
  const auto scans = map.rotate_scans(test::scan_from(grid, {1.5, 1.0, 0.3}, 24), map.space());
  ScanShifts shifts(1, scans);
  int stopped = 0;
  for (std::size_t yaw = 0; yaw < scans.size(); ++yaw) {
    const Tile tile{0, static_cast<int>(yaw) % map.pyramid[0].layout().tile_rows, 0};
    const TileSums whole =
        tile_sums(map.pyramid[0], tile, shifts.at(map.pyramid[0].layout(), yaw)).sums;
    const int best = *std::max_element(whole.begin(), whole.end());
    EXPECT_EQ(tile_sums(map.pyramid[0], tile, shifts.at(map.pyramid[0].layout(), yaw), best).sums,
              whole);
    const TileScore score =
        tile_sums(map.pyramid[0], tile, shifts.at(map.pyramid[0].layout(), yaw), 255 * 20);
    if (score.points == shifts.at(map.pyramid[0].layout(), yaw).size()) {
      EXPECT_EQ(score.sums, whole);
    } else {
      ++stopped;
      EXPECT_LT(best, 255 * 20);
      EXPECT_LT(*std::max_element(score.sums.begin(), score.sums.end()), 255 * 20);
    }
  }
  EXPECT_GT(stopped, 0);
}

/// Highest value of a node's cells under a shifted square, quantised as the level's deficits.
int naive_bound(const test::SearchedMap& map, const PooledField& level, const CellOffset& o,
                int column, int row) {
  const int edge = level.layout().edge;
  int best = 0;
  for (int k = 0; k < edge * edge; ++k) {
    best = std::max(best, test::byte_at(map.field, edge * column + o.dx + k % edge,
                                        edge * row + o.dy + k / edge));
  }
  return 255 - (255 - best) / level.step() * level.step();
}

TEST(TileSums, EqualTheNaiveLoopAtCoarseLevels) {
  Rng rng = substream(4, "tile_sums");
  const OccupancyGrid grid = test::random_room(rng);
  const test::SearchedMap map(grid);
  const auto scans = map.rotate_scans(test::scan_from(grid, {1.5, 1.0, 0.3}, 24), map.space());
  ScanShifts shifts(map.pyramid.size(), scans);
  for (const PooledField& level : map.pyramid) {
    for (std::size_t yaw = 0; yaw < scans.size(); yaw += 3) {
      const Tile tile{static_cast<int>(yaw) % level.layout().tile_columns,
                      static_cast<int>(yaw) % level.layout().tile_rows, 0};
      const TileSums sums = tile_sums(level, tile, shifts.at(level.layout(), yaw)).sums;
      for (int j = 0; j < 16; ++j) {
        int expected = 0;
        for (const CellOffset& o : scans[yaw]) {
          expected += naive_bound(map, level, o, 8 * tile.column + j % 8, 2 * tile.row + j / 8);
        }
        ASSERT_EQ(sums[static_cast<std::size_t>(j)], expected);
      }
    }
  }
}

TEST(TileBounds, AreTheBestSumsOfTheFreeNodesOfEachChild) {
  Rng rng = substream(5, "tile_sums");
  const OccupancyGrid grid = test::random_room(rng);
  const test::SearchedMap map(grid);
  const auto scans = map.rotate_scans(test::scan_from(grid, {1.5, 1.0, 0.3}, 24), map.space());
  ScanShifts shifts(map.pyramid.size(), scans);
  const PooledField& level = map.pyramid[1];
  for (int k = 0; k < level.layout().tile_columns * level.layout().tile_rows; ++k) {
    const Tile tile{k % level.layout().tile_columns, k / level.layout().tile_columns, 0};
    const auto at = shifts.at(level.layout(), static_cast<std::size_t>(k) % scans.size());
    const TileSums sums = tile_sums(level, tile, at).sums;
    ChildBounds expected{};
    for (std::size_t j = 0; j < 16; ++j) {
      if ((level.free_nodes(tile.column, tile.row) >> j & 1U) == 0) continue;
      expected[j / 4] = std::max(expected[j / 4], sums[j]);
    }
    EXPECT_EQ(tile_bounds(level, tile, at).children, expected);
    const auto best = *std::max_element(expected.begin(), expected.end());
    EXPECT_EQ(tile_bounds(level, tile, at, best).children, expected);
    const ChildBounds partial = tile_bounds(level, tile, at, 255 * 24).children;
    const int least = 255 * 24;
    EXPECT_EQ(*std::max_element(partial.begin(), partial.end()) < least, best < least);
  }
}

TEST(TileBounds, StopAtOnceIfNothingCanReachTheLeast) {
  Rng rng = substream(6, "tile_sums");
  const test::SearchedMap map(test::random_room(rng));
  const std::vector<std::int32_t> shifts(24, 0);
  const TileBounds bounds = tile_bounds(map.pyramid[1], {}, shifts, 255 * 24 + 1);
  EXPECT_EQ(bounds.points, 16U);
  EXPECT_LE(*std::max_element(bounds.children.begin(), bounds.children.end()), 255 * 24);
}

TEST(TileSums, DoNotOverflow) {
  OccupancyGrid grid;
  grid.frame = {8, 2, 0.2, {}};
  grid.cells.assign(16, CellState::kOccupied);
  const ByteField field(grid, DistanceField(grid, 5.0), {0.2, 0.15, 1.0});
  const PooledField cells(field, 0);
  const std::vector<std::int32_t> shifts(256, cells.layout().shift(0, 0));
  for (const std::uint16_t sum : tile_sums(cells, {}, shifts).sums) EXPECT_EQ(sum, 256 * 255);
}

}  // namespace
}  // namespace castaway::localization
