#include "localization/matching/tile_sums.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/localization/matching/search_case.hpp"

namespace castaway::localization {
namespace {

TEST(TileSums, EqualTheNaiveLoop) {
  Rng rng = substream(1, "tile_sums");
  const OccupancyGrid grid = test::random_room(rng);
  const test::SearchedMap map(grid);
  const SearchSpace space = map.space();
  const auto scans = map.rotate_scans(test::scan_from(grid, {1.5, 1.0, 0.3}, 24), space);
  const ScanShifts shifts(map.pyramid[0], scans);
  for (std::size_t yaw = 0; yaw < scans.size(); ++yaw) {
    const Tile tile{static_cast<int>(yaw) % map.pyramid[0].layout().tile_columns,
                    static_cast<int>(yaw) % map.pyramid[0].layout().tile_rows,
                    static_cast<int>(yaw)};
    const TileSums sums = tile_sums(map.pyramid[0], tile, shifts.at(yaw)).sums;
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
  const ScanShifts shifts(map.pyramid[0], scans);
  int stopped = 0;
  for (std::size_t yaw = 0; yaw < scans.size(); ++yaw) {
    const Tile tile{0, static_cast<int>(yaw) % map.pyramid[0].layout().tile_rows, 0};
    const TileSums whole = tile_sums(map.pyramid[0], tile, shifts.at(yaw)).sums;
    const int best = *std::max_element(whole.begin(), whole.end());
    EXPECT_EQ(tile_sums(map.pyramid[0], tile, shifts.at(yaw), best).sums, whole);
    const TileScore score = tile_sums(map.pyramid[0], tile, shifts.at(yaw), 255 * 20);
    if (score.points == shifts.at(yaw).size()) {
      EXPECT_EQ(score.sums, whole);
    } else {
      ++stopped;
      EXPECT_LT(best, 255 * 20);
      EXPECT_LT(*std::max_element(score.sums.begin(), score.sums.end()), 255 * 20);
    }
  }
  EXPECT_GT(stopped, 0);
}

TEST(ScanShifts, HoldEveryPointOnce) {
  Rng rng = substream(3, "tile_sums");
  const OccupancyGrid grid = test::random_room(rng);
  const test::SearchedMap map(grid);
  const auto scans = map.rotate_scans(test::scan_from(grid, {1.5, 1.0, 0.3}, 24), map.space());
  const ScanShifts shifts(map.pyramid[0], scans);
  for (std::size_t yaw = 0; yaw < scans.size(); ++yaw) {
    std::vector<std::int32_t> expected;
    for (const CellOffset& o : scans[yaw]) {
      expected.push_back(map.pyramid[0].layout().shift(o.dx, o.dy));
    }
    std::vector<std::int32_t> held(shifts.at(yaw).begin(), shifts.at(yaw).end());
    std::sort(expected.begin(), expected.end());
    std::sort(held.begin(), held.end());
    EXPECT_EQ(held, expected);
  }
}

TEST(TileSums, DoNotOverflow) {
  OccupancyGrid grid;
  grid.frame = {8, 2, 0.2, {}};
  grid.cells.assign(16, CellState::kOccupied);
  const ByteField field(grid, DistanceField(grid, 5.0), {0.2, 0.15, 1.0});
  const PooledField cells(field, 1);
  const std::vector<std::int32_t> shifts(256, cells.layout().shift(0, 0));
  for (const std::uint16_t sum : tile_sums(cells, {}, shifts).sums) EXPECT_EQ(sum, 256 * 255);
}

}  // namespace
}  // namespace castaway::localization
