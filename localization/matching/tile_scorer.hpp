/// Scores tiles of a pyramid for one scan: upper bounds at the coarse levels, scores at the finest.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "localization/map/pooled_field.hpp"
#include "localization/matching/search_space.hpp"
#include "localization/matching/tile_sums.hpp"

namespace castaway::localization {

/// Levels of a map, the finest (edge 1) first; each has twice the edge of the previous one.
using Pyramid = std::vector<PooledField>;

/// Builds a pyramid of `levels` >= 1.
Pyramid make_pyramid(const ByteField& field, int levels);

/// A tile and the upper bounds of its children: lower left, lower right, upper left, upper right.
struct BoundedTile {
  Tile tile;
  std::array<std::uint16_t, 4> bounds{};

  /// The largest bound.
  [[nodiscard]] int bound() const { return *std::max_element(bounds.begin(), bounds.end()); }
};

/// The end points of a scan at every yaw of a search, on every level of a pyramid, which must
/// outlive it. Counts the tiles scored.
class TileScorer {
 public:
  /// `scans[i]` is the scan rotated by yaw i.
  TileScorer(const Pyramid& pyramid, const std::vector<std::vector<CellOffset>>& scans);

  [[nodiscard]] std::size_t top_level() const { return pyramid_->size() - 1; }
  [[nodiscard]] const PooledField& level(std::size_t level) const { return (*pyramid_)[level]; }
  /// Sums of all nodes of a tile; partial ones if all are below `least`.
  TileSums score(std::size_t level, const Tile& tile, int least);
  /// Bounds of the free nodes of a tile. A child covers four nodes of one row. If no bound reaches
  /// `least`, they are partial.
  BoundedTile bound(std::size_t level, const Tile& tile, int least);
  /// Work so far, in tiles of 64 end points: 1024 byte sums each.
  [[nodiscard]] std::int64_t scored() const { return points_ / 64; }

 private:
  const Pyramid* pyramid_;
  std::vector<ScanShifts> shifts_;  ///< For each level.
  std::int64_t points_ = 0;         ///< End points of all tiles.
};

}  // namespace castaway::localization
