/// Sums of the deficits of 16 neighbouring nodes (`PooledField`) at once, by vector extensions of
/// GCC and Clang.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <span>

#include "localization/map/pooled_field.hpp"

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

}  // namespace castaway::localization
