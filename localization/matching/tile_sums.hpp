/// The inner loop of the global search: scores and upper bounds of 16 neighbouring nodes at once.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <span>

#include "localization/map/pooled_field.hpp"
#include "localization/matching/search_space.hpp"

namespace castaway::localization {

using Bytes16 = std::uint8_t __attribute__((vector_size(16)));
using Words8 = std::uint16_t __attribute__((vector_size(16)));

/// The 16-bit words of both rows of a tile.
struct TileWords {
  Words8 lower{};
  Words8 upper{};
};

/// Sums of the deficits of a tile. They cannot overflow with 256 end points: 256 * 255 < 2^16.
class DeficitSums {
 public:
  static constexpr std::size_t kBlock = 16;  ///< Points whose coarse deficits a byte can hold.

  /// Adds the deficits of the finest level under some end points.
  void add_fine(const std::uint8_t* tile, std::span<const std::int32_t> shifts) {
    for (const std::int32_t shift : shifts) add(load(tile + shift));
  }
  /// Adds coarse deficits under at most `kBlock` end points.
  void add_coarse(const std::uint8_t* tile, std::span<const std::int32_t> shifts) {
    static_assert(kBlock * (PooledField::kBest / PooledField::kCoarseStep) <= 255);
    Bytes16 block{};
    if (shifts.size() == kBlock) {  // Constant, so that the loop is unrolled.
      for (std::size_t i = 0; i < kBlock; ++i) block += load(tile + shifts[i]);
    } else {
      for (const std::int32_t shift : shifts) block += load(tile + shift);
    }
    add(block);
  }
  [[nodiscard]] TileWords words() const {
    return {static_cast<Words8>(all_ - (upper_ << 8)), upper_};  // Modulo 2^16.
  }
  /// True if a sum is at most `limit`.
  [[nodiscard]] bool any_within(int limit) const {
    if (limit < 0) return false;
    const Words8 most = Words8{} + static_cast<std::uint16_t>(limit);
    const TileWords sums = words();
    const auto within = (sums.lower <= most) | (sums.upper <= most);
    std::array<std::uint64_t, 2> bits;
    std::memcpy(bits.data(), &within, sizeof within);
    return (bits[0] | bits[1]) != 0;
  }

 private:
  static Bytes16 load(const std::uint8_t* from) {
    Bytes16 bytes;
    std::memcpy(&bytes, from, sizeof bytes);
    return bytes;
  }
  void add(const Bytes16& bytes) {
    static_assert(std::endian::native == std::endian::little);
    Words8 words;
    std::memcpy(&words, &bytes, sizeof words);
    all_ += words;
    upper_ += words >> 8;
  }

  Words8 all_{};  ///< Sums of lower + 256 upper, modulo 2^16.
  Words8 upper_{};
};

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
