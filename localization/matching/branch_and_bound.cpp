#include "localization/matching/branch_and_bound.hpp"

#include <cassert>

#include "localization/matching/tiles.hpp"

namespace castaway::localization {
namespace {

/// Indices by descending bound (counting sort: the bounds are small integers).
std::vector<std::uint32_t> order_by_bound(const std::vector<BoundedTile>& tiles) {
  int highest = 0;
  for (const BoundedTile& tile : tiles) highest = std::max(highest, tile.bound());
  std::vector<std::uint32_t> next(static_cast<std::size_t>(highest) + 2);
  const auto slot = [&](const BoundedTile& tile) {
    return static_cast<std::size_t>(highest - tile.bound());
  };
  for (const BoundedTile& tile : tiles) ++next[slot(tile) + 1];
  for (std::size_t i = 1; i < next.size(); ++i) next[i] += next[i - 1];
  std::vector<std::uint32_t> order(tiles.size());
  for (std::uint32_t i = 0; i < tiles.size(); ++i) order[next[slot(tiles[i])]++] = i;
  return order;
}

}  // namespace

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

BranchAndBound::BranchAndBound(const Pyramid& pyramid, SearchSpace space,
                               const std::vector<std::vector<CellOffset>>& scans, BestPlaces best)
    : scorer_(pyramid, scans),
      space_(std::move(space)),
      best_(std::move(best)),
      tiles_(tiles_within(pyramid.back(), space_)) {
  assert(scans.size() == space_.yaws.size());
}

bool BranchAndBound::step(std::int64_t tiles) {
  const std::int64_t end = scorer_.scored() + std::max<std::int64_t>(tiles, 1);
  while (visited_ < tiles_.size() * space_.yaws.size()) {
    if (scorer_.scored() >= end) return false;
    visit_next_root();
  }
  for (; expanded_ < order_.size(); ++expanded_) {
    const BoundedTile& root = roots_[order_[expanded_]];
    if (root.bound() < best_.threshold()) break;
    if (scorer_.scored() >= end) return false;
    expand(scorer_.top_level(), root);
  }
  return complete_ = true;
}

/// Bounds the next tile of the coarsest level, or offers it if that is the finest one.
void BranchAndBound::visit_next_root() {
  const std::size_t top = scorer_.top_level();
  Tile tile = tiles_[visited_ % tiles_.size()];
  tile.yaw = static_cast<int>(visited_ / tiles_.size());
  if (top == 0) {
    descend(top, tile);
  } else {
    const BoundedTile root = scorer_.bound(top, tile, best_.threshold());
    if (root.bound() >= best_.threshold()) roots_.push_back(root);
  }
  if (++visited_ == tiles_.size() * space_.yaws.size()) order_ = order_by_bound(roots_);
}

/// Descends where a bound allows a cell below it to change the list.
void BranchAndBound::expand(std::size_t level, const BoundedTile& parent) {
  const Tile& tile = parent.tile;
  for (int child = 0; child < 4; ++child) {
    if (parent.children[static_cast<std::size_t>(child)] < best_.threshold()) continue;
    descend(level - 1, {2 * tile.column + child % 2, 2 * tile.row + child / 2, tile.yaw});
  }
}

void BranchAndBound::descend(std::size_t level, const Tile& tile) {
  const PooledField& field = scorer_.level(level);
  if (tile.column >= field.layout().tile_columns || tile.row >= field.layout().tile_rows) return;
  if (field.free_nodes(tile.column, tile.row) == 0) return;
  if (outside(field, space_, tile.column, tile.row)) return;
  if (level > 0) return expand(level, scorer_.bound(level, tile, best_.threshold()));
  offer_tile(field, space_, tile, scorer_.score(tile, best_.threshold()), best_);
}

}  // namespace castaway::localization
