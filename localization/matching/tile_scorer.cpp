#include "localization/matching/tile_scorer.hpp"

namespace castaway::localization {

Pyramid make_pyramid(const ByteField& field, int levels) {
  Pyramid pyramid;
  for (int level = 0; level < levels; ++level) pyramid.emplace_back(field, 1 << level);
  return pyramid;
}

TileScorer::TileScorer(const Pyramid& pyramid, const std::vector<std::vector<CellOffset>>& scans)
    : pyramid_(&pyramid) {
  for (const PooledField& level : pyramid) shifts_.emplace_back(level, scans);
}

TileSums TileScorer::score(std::size_t level, const Tile& tile, int least) {
  const TileScore score = tile_sums((*pyramid_)[level], tile,
                                    shifts_[level].at(static_cast<std::size_t>(tile.yaw)), least);
  points_ += static_cast<std::int64_t>(score.points);
  return score.sums;
}

BoundedTile TileScorer::bound(std::size_t level, const Tile& tile, int least) {
  const TileSums sums = score(level, tile, least);
  const unsigned free = (*pyramid_)[level].free_nodes(tile.column, tile.row);
  BoundedTile bounded{tile, {}};
  for (std::size_t j = 0; j < sums.size(); ++j) {
    std::uint16_t& bound = bounded.bounds[j / 4];
    if ((free >> j & 1U) != 0) bound = std::max(bound, sums[j]);
  }
  return bounded;
}

}  // namespace castaway::localization
