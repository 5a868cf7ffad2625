#include "localization/matching/tile_sums.hpp"

#include <bit>
#include <cassert>
#include <cstring>

namespace castaway::localization {
namespace {

/// Two words of four 16-bit sums each, for the bytes at even and odd positions. The sums cannot
/// overflow into each other: 256 * 255 < 2^16.
struct RowSums {
  std::uint64_t even = 0;
  std::uint64_t odd = 0;

  void add(const std::uint8_t* bytes) {
    static_assert(std::endian::native == std::endian::little);
    static_assert(PooledLayout::kTileColumns == sizeof(std::uint64_t));
    constexpr std::uint64_t kEven = 0x00FF00FF00FF00FF;
    std::uint64_t word = 0;
    std::memcpy(&word, bytes, sizeof word);
    even += word & kEven;
    odd += word >> 8U & kEven;
  }
  void store(std::uint16_t* sums) const {
    for (unsigned pair = 0; pair < 4; ++pair) {
      sums[2 * pair] = static_cast<std::uint16_t>(even >> 16U * pair);
      sums[2 * pair + 1] = static_cast<std::uint16_t>(odd >> 16U * pair);
    }
  }
};

}  // namespace

ScanShifts::ScanShifts(const PooledField& level, const std::vector<std::vector<CellOffset>>& scans)
    : first_{0} {
  for (const auto& scan : scans) first_.push_back(first_.back() + scan.size());
  shifts_.reserve(first_.back());
  for (const auto& scan : scans) {
    for (const CellOffset& o : scan) shifts_.push_back(level.layout().shift(o.dx, o.dy));
  }
}

TileSums tile_sums(const PooledField& level, const Tile& tile,
                   std::span<const std::int32_t> shifts) {
  assert(shifts.size() <= 256);
  static_assert(PooledLayout::kTileRows == 2);
  const std::uint8_t* base = level.tile(tile.column, tile.row);
  const std::ptrdiff_t stride = level.layout().stride;
  RowSums lower;
  RowSums upper;
  for (const std::int32_t shift : shifts) {
    lower.add(base + shift);
    upper.add(base + shift + stride);
  }
  TileSums sums;
  lower.store(sums.data());
  upper.store(sums.data() + PooledLayout::kTileColumns);
  return sums;
}

}  // namespace castaway::localization
