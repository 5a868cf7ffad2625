/// Scores tiles of a pyramid for one scan: upper bounds at the coarse levels, scores at the finest.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "localization/map/pooled_field.hpp"
#include "localization/matching/scan_shifts.hpp"
#include "localization/matching/search_space.hpp"
#include "localization/matching/tile_sums.hpp"

namespace castaway::localization {

/// Levels of a map, the finest (edge 1) first; each has twice the edge of the previous one.
using Pyramid = std::vector<PooledField>;

/// Builds a pyramid of `levels` >= 1.
Pyramid make_pyramid(const ByteField& field, int levels);

/// A tile and the upper bounds of its children.
struct BoundedTile {
  Tile tile;
  ChildBounds children;

  /// The largest bound.
  [[nodiscard]] int bound() const { return *std::max_element(children.begin(), children.end()); }
};

/// The end points of a scan at every yaw of a search, on every level of a pyramid, which must
/// outlive it. Counts the tiles scored.
class TileScorer {
 public:
  /// `scans[i]` is the scan rotated by yaw i.
  TileScorer(const Pyramid& pyramid, const std::vector<std::vector<CellOffset>>& scans);

  [[nodiscard]] std::size_t top_level() const { return pyramid_->size() - 1; }
  [[nodiscard]] const PooledField& level(std::size_t level) const { return (*pyramid_)[level]; }
  /// Scores of a tile of the finest level (`tile_sums`).
  TileSums score(const Tile& tile, int least);
  /// Bounds of a tile of a coarse level (`tile_bounds`).
  BoundedTile bound(std::size_t level, const Tile& tile, int least);
  /// Work so far, in tiles of the finest level with 64 end points. In the same time, 96 end points
  /// of a coarse level are summed.
  [[nodiscard]] std::int64_t scored() const { return work_ / (64 * kFineWork); }

 private:
  static constexpr std::int64_t kFineWork = 3;  ///< Of an end point at the finest level.
  static constexpr std::int64_t kCoarseWork = 2;

  const Pyramid* pyramid_;
  ScanShifts shifts_;
  std::int64_t work_ = 0;  ///< Of the end points of all tiles.
};

}  // namespace castaway::localization
