#include "localization/matching/branch_and_bound.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

#include "localization/matching/tiles.hpp"

namespace castaway::localization {
namespace {

/// Sorts by descending bound (counting sort: the bounds are small integers).
std::vector<BoundedTile> sort_by_bound(const std::vector<BoundedTile>& tiles) {
  int highest = 0;
  for (const BoundedTile& tile : tiles) highest = std::max(highest, tile.bound());
  std::vector<std::size_t> next(static_cast<std::size_t>(highest) + 2);
  const auto slot = [&](const BoundedTile& tile) {
    return static_cast<std::size_t>(highest - tile.bound());
  };
  for (const BoundedTile& tile : tiles) ++next[slot(tile) + 1];
  for (std::size_t i = 1; i < next.size(); ++i) next[i] += next[i - 1];
  std::vector<BoundedTile> sorted(tiles.size());
  for (const BoundedTile& tile : tiles) sorted[next[slot(tile)]++] = tile;
  return sorted;
}

}  // namespace

BranchAndBound::BranchAndBound(const Pyramid& pyramid, SearchSpace space,
                               const std::vector<std::vector<CellOffset>>& scans, BestPlaces best)
    : scorer_(pyramid, scans), space_(std::move(space)), best_(std::move(best)) {
  assert(scans.size() == space_.yaws.size());
  const std::vector<Tile> tiles = tiles_within(pyramid.back(), space_);
  roots_.reserve(tiles.size() * scans.size());
  for (std::size_t yaw = 0; yaw < scans.size(); ++yaw) {
    for (const Tile& tile : tiles) {
      roots_.push_back({{tile.column, tile.row, static_cast<int>(yaw)}, {}});
    }
  }
}

bool BranchAndBound::step(std::int64_t tiles) {
  const std::int64_t end = scorer_.scored() + std::max<std::int64_t>(tiles, 1);
  const std::size_t top = scorer_.top_level();
  for (; bounded_ < roots_.size(); ++bounded_) {
    if (scorer_.scored() >= end) return false;
    roots_[bounded_] = scorer_.bound(top, roots_[bounded_].tile, best_.threshold());
    if (bounded_ + 1 == roots_.size()) roots_ = sort_by_bound(roots_);
  }
  for (; expanded_ < roots_.size(); ++expanded_) {
    if (roots_[expanded_].bound() < best_.threshold()) break;
    if (scorer_.scored() >= end) return false;
    expand(top, roots_[expanded_]);
  }
  return complete_ = true;
}

/// Descends where a bound allows a cell below it to change the list.
void BranchAndBound::expand(std::size_t level, const BoundedTile& parent) {
  if (level == 0) return descend(0, parent.tile);
  const Tile& tile = parent.tile;
  for (int child = 0; child < 4; ++child) {
    if (parent.bounds[static_cast<std::size_t>(child)] < best_.threshold()) continue;
    descend(level - 1, {2 * tile.column + child % 2, 2 * tile.row + child / 2, tile.yaw});
  }
}

void BranchAndBound::descend(std::size_t level, const Tile& tile) {
  const PooledField& field = scorer_.level(level);
  if (tile.column >= field.layout().tile_columns || tile.row >= field.layout().tile_rows) return;
  if (field.free_nodes(tile.column, tile.row) == 0) return;
  if (outside(field, space_, tile.column, tile.row)) return;
  if (level > 0) return expand(level, scorer_.bound(level, tile, best_.threshold()));
  offer_tile(field, space_, tile, scorer_.score(level, tile, best_.threshold()), best_);
}

}  // namespace castaway::localization
