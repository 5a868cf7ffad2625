#include "localization/matching/tile_scorer.hpp"

namespace castaway::localization {

Pyramid make_pyramid(const ByteField& field, int levels) {
  Pyramid pyramid;
  for (int level = 0; level < levels; ++level) pyramid.emplace_back(field, level);
  return pyramid;
}

TileScorer::TileScorer(const Pyramid& pyramid, const std::vector<std::vector<CellOffset>>& scans)
    : pyramid_(&pyramid), shifts_(pyramid.size(), scans) {}

TileSums TileScorer::score(const Tile& tile, int least) {
  const PooledField& cells = pyramid_->front();
  const auto shifts = shifts_.at(cells.layout(), static_cast<std::size_t>(tile.yaw));
  const TileScore score = tile_sums(cells, tile, shifts, least);
  work_ += kFineWork * static_cast<std::int64_t>(score.points);
  return score.sums;
}

BoundedTile TileScorer::bound(std::size_t level, const Tile& tile, int least) {
  const PooledField& field = (*pyramid_)[level];
  const auto shifts = shifts_.at(field.layout(), static_cast<std::size_t>(tile.yaw));
  const TileBounds bounds = tile_bounds(field, tile, shifts, least);
  work_ += kCoarseWork * static_cast<std::int64_t>(bounds.points);
  return {tile, bounds.children};
}

}  // namespace castaway::localization
