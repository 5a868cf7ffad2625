#include "localization/matching/tile_sums.hpp"

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
    const TileSums sums = tile_sums(map.pyramid[0], tile, shifts.at(yaw));
    for (int j = 0; j < 16; ++j) {
      EXPECT_EQ(
          sums[static_cast<std::size_t>(j)],
          test::naive_score(map.field, scans[yaw], 8 * tile.column + j % 8, 2 * tile.row + j / 8));
    }
  }
}

TEST(TileSums, DoNotOverflow) {
  OccupancyGrid grid;
  grid.frame = {8, 2, 0.2, {}};
  grid.cells.assign(16, CellState::kOccupied);
  const ByteField field(grid, DistanceField(grid, 5.0), {0.2, 0.15, 1.0});
  const PooledField cells(field, 1);
  const std::vector<std::int32_t> shifts(256, cells.layout().shift(0, 0));
  for (const std::uint16_t sum : tile_sums(cells, {}, shifts)) EXPECT_EQ(sum, 256 * 255);
}

}  // namespace
}  // namespace castaway::localization
