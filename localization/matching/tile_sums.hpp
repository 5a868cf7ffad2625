/// The inner loop of the global search: byte sums of 16 neighbouring nodes at once.
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

/// A scan's end points at every yaw of a search, as byte offsets on one level.
class ScanShifts {
 public:
  /// `scans[i]` is the scan rotated by yaw i. The shifts of a yaw are in a mixed order, so that the
  /// first ones are spread over the scan.
  ScanShifts(const PooledField& level, const std::vector<std::vector<CellOffset>>& scans);

  [[nodiscard]] std::span<const std::int32_t> at(std::size_t yaw) const {
    return std::span(shifts_).subspan(first_[yaw], first_[yaw + 1] - first_[yaw]);
  }

 private:
  std::vector<std::size_t> first_;  ///< Index of the first shift of every yaw, and the end.
  std::vector<std::int32_t> shifts_;
};

/// The sums of a tile, and the number of end points that they took.
struct TileScore {
  TileSums sums{};
  std::size_t points = 0;
};

/// Sums the bytes of a tile's nodes under at most 256 end points, given as shifts on that level.
/// Stops as soon as no node can reach `least`; all sums are below it then.
TileScore tile_sums(const PooledField& level, const Tile& tile,
                    std::span<const std::int32_t> shifts, int least = 0);

}  // namespace castaway::localization
