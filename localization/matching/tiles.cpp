#include "localization/matching/tiles.hpp"

namespace castaway::localization {
namespace {

constexpr int kColumns = PooledLayout::kTileColumns;
constexpr int kRows = PooledLayout::kTileRows;

}  // namespace

bool outside(const PooledField& level, const SearchSpace& space, int column, int row) {
  const int width = level.layout().edge * kColumns;
  const int height = level.layout().edge * kRows;
  return column * width > space.high.x() || (column + 1) * width <= space.low.x() ||
         row * height > space.high.y() || (row + 1) * height <= space.low.y();
}

std::vector<Tile> tiles_within(const PooledField& level, const SearchSpace& space) {
  std::vector<Tile> tiles;
  for (int row = 0; row < level.layout().tile_rows; ++row) {
    for (int column = 0; column < level.layout().tile_columns; ++column) {
      if (level.free_nodes(column, row) == 0 || outside(level, space, column, row)) continue;
      tiles.push_back({column, row, 0});
    }
  }
  return tiles;
}

void offer_tile(const PooledField& cells, const SearchSpace& space, const Tile& tile,
                const TileSums& scores, BestPlaces& best) {
  const unsigned free = cells.free_nodes(tile.column, tile.row);
  const bool in_one_bin = best.holds_tiles(kColumns, kRows);
  int least = best.threshold();
  Place found;  // The newest one; in one bin the first of the best.
  for (int j = 0; j < kColumns * kRows; ++j) {
    const int score = scores[static_cast<std::size_t>(j)];
    if (score < least || (free >> static_cast<unsigned>(j) & 1U) == 0) continue;
    const Eigen::Vector2i cell(kColumns * tile.column + j % kColumns,
                               kRows * tile.row + j / kColumns);
    if (!space.contains(cell)) continue;
    found = {cell.x(), cell.y(), space.yaws[static_cast<std::size_t>(tile.yaw)], score};
    if (in_one_bin) {
      least = score + 1;
    } else {
      best.offer(found);
    }
  }
  if (in_one_bin && found.score > 0) best.offer(found);
}

}  // namespace castaway::localization
