/// The inner loop of the global search: scores and upper bounds of 16 neighbouring nodes at once.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "localization/map/pooled_field.hpp"
#include "localization/matching/search_space.hpp"

namespace castaway::localization {

/// Sums of a tile's nodes, lower row first. At edge 1 they are scores, otherwise upper bounds of
/// the scores of all cells that a node covers.
using TileSums = std::array<std::uint16_t, PooledLayout::kTileColumns * PooledLayout::kTileRows>;

/// The sums of a tile, and the number of end points that they took.
struct TileScore {
  TileSums sums{};
  std::size_t points = 0;
};

/// Bounds of the four children of a tile: lower left, lower right, upper left, upper right. A child
/// covers four nodes of one row.
using ChildBounds = std::array<std::uint16_t, 4>;

/// The bounds of a tile, and the number of end points that they took.
struct TileBounds {
  ChildBounds children{};
  std::size_t points = 0;
};

/// Sums the values of a tile's nodes under at most 256 end points, given as shifts on that level.
/// Stops as soon as no node can reach `least`; all sums are below it then.
TileScore tile_sums(const PooledField& level, const Tile& tile,
                    std::span<const std::int32_t> shifts, int least = 0);

/// The largest sums of the free nodes of a tile of a coarse level for each child; 0 for a child
/// without free nodes. Stops as `tile_sums`.
TileBounds tile_bounds(const PooledField& level, const Tile& tile,
                       std::span<const std::int32_t> shifts, int least = 0);

}  // namespace castaway::localization
