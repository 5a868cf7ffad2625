#include "localization/matching/branch_and_bound.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

#include "localization/matching/tiles.hpp"

namespace castaway::localization {

Pyramid make_pyramid(const ByteField& field, int levels) {
  Pyramid pyramid;
  for (int level = 0; level < levels; ++level) pyramid.emplace_back(field, 1 << level);
  return pyramid;
}

BranchAndBound::BranchAndBound(const Pyramid& pyramid, SearchSpace space,
                               const std::vector<std::vector<CellOffset>>& scans, BestPlaces best)
    : pyramid_(&pyramid), space_(std::move(space)), best_(std::move(best)) {
  assert(scans.size() == space_.yaws.size());
  for (const PooledField& level : pyramid) shifts_.emplace_back(level, scans);
  const std::vector<Tile> tiles = tiles_within(pyramid.back(), space_);
  roots_.reserve(tiles.size() * scans.size());
  for (std::size_t yaw = 0; yaw < scans.size(); ++yaw) {
    for (const Tile& tile : tiles) {
      roots_.push_back({{tile.column, tile.row, static_cast<int>(yaw)}, {}});
    }
  }
}

int BranchAndBound::Node::bound() const { return *std::max_element(bounds.begin(), bounds.end()); }

bool BranchAndBound::step(std::int64_t tiles) {
  const std::int64_t end = scored_ + std::max<std::int64_t>(tiles, 1);
  const std::size_t top = pyramid_->size() - 1;
  for (; bounded_ < roots_.size(); ++bounded_) {
    if (scored_ >= end) return false;
    roots_[bounded_] = bound_node(top, roots_[bounded_].tile);
    if (bounded_ + 1 == roots_.size()) sort_roots();
  }
  for (; expanded_ < roots_.size(); ++expanded_) {
    if (roots_[expanded_].bound() < best_.threshold()) break;
    if (scored_ >= end) return false;
    expand(top, roots_[expanded_]);
  }
  return complete_ = true;
}

TileSums BranchAndBound::score(std::size_t level, const Tile& tile) {
  ++scored_;
  return tile_sums((*pyramid_)[level], tile, shifts_[level].at(static_cast<std::size_t>(tile.yaw)));
}

/// A child covers four nodes of one row of the tile.
BranchAndBound::Node BranchAndBound::bound_node(std::size_t level, const Tile& tile) {
  const TileSums sums = score(level, tile);
  const unsigned free = (*pyramid_)[level].free_nodes(tile.column, tile.row);
  Node node{tile, {}};
  for (std::size_t j = 0; j < sums.size(); ++j) {
    if ((free >> j & 1U) != 0) node.bounds[j / 4] = std::max(node.bounds[j / 4], sums[j]);
  }
  return node;
}

/// Sorts the roots by descending bound (counting sort: the bounds are small integers).
void BranchAndBound::sort_roots() {
  int highest = 0;
  for (const Node& root : roots_) highest = std::max(highest, root.bound());
  std::vector<std::size_t> next(static_cast<std::size_t>(highest) + 2);
  const auto slot = [&](const Node& node) {
    return static_cast<std::size_t>(highest - node.bound());
  };
  for (const Node& root : roots_) ++next[slot(root) + 1];
  for (std::size_t i = 1; i < next.size(); ++i) next[i] += next[i - 1];
  std::vector<Node> sorted(roots_.size());
  for (const Node& root : roots_) sorted[next[slot(root)]++] = root;
  roots_ = std::move(sorted);
}

/// Descends where a node's bounds allow a cell below it to change the list.
void BranchAndBound::expand(std::size_t level, const Node& node) {
  if (level == 0) return descend(0, node.tile);
  for (int child = 0; child < 4; ++child) {
    if (node.bounds[static_cast<std::size_t>(child)] < best_.threshold()) continue;
    descend(level - 1,
            {2 * node.tile.column + child % 2, 2 * node.tile.row + child / 2, node.tile.yaw});
  }
}

void BranchAndBound::descend(std::size_t level, const Tile& tile) {
  const PooledField& field = (*pyramid_)[level];
  if (tile.column >= field.tile_columns() || tile.row >= field.tile_rows()) return;
  if (field.free_nodes(tile.column, tile.row) == 0) return;
  if (outside(field, space_, tile.column, tile.row)) return;
  if (level > 0) return expand(level, bound_node(level, tile));
  offer_tile(field, space_, tile, score(level, tile), best_);
}

}  // namespace castaway::localization
