#include "localization/matching/tile_sums.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cstring>
#include <numeric>

namespace castaway::localization {
namespace {

constexpr int kByteLimit = 255;

using Words = std::uint16_t __attribute__((vector_size(16)));

/// The 16-bit sums of the bytes at even and odd positions of both rows, in one register each. They
/// cannot overflow: 256 * 255 < 2^16.
struct Sums {
  Words even{};
  Words odd{};

  void add(const std::uint8_t* lower, const std::uint8_t* upper) {
    static_assert(std::endian::native == std::endian::little);
    static_assert(PooledLayout::kTileColumns * PooledLayout::kTileRows == sizeof(Words));
    std::array<std::uint8_t, sizeof(Words)> bytes;
    std::memcpy(bytes.data(), lower, sizeof(Words) / 2);
    std::memcpy(bytes.data() + sizeof(Words) / 2, upper, sizeof(Words) / 2);
    Words words;
    std::memcpy(&words, bytes.data(), sizeof words);
    even += words & 0xFF;
    odd += words >> 8;
  }
  [[nodiscard]] bool any_reaches(int least) const {
    if (least <= 0) return true;
    const Words needed = Words{} + static_cast<std::uint16_t>(least);
    const auto reached = (even >= needed) | (odd >= needed);
    std::array<std::uint64_t, 2> bits;
    std::memcpy(bits.data(), &reached, sizeof reached);
    return (bits[0] | bits[1]) != 0;
  }
};

/// A step through `size` items that visits each once and neighbours far apart: coprime, near the
/// golden section.
std::size_t mixing_step(std::size_t size) {
  auto step = static_cast<std::size_t>(0.618 * static_cast<double>(size));
  while (step > 1 && std::gcd(step, size) != 1) --step;
  return std::max<std::size_t>(step, 1);
}

}  // namespace

ScanShifts::ScanShifts(const PooledField& level, const std::vector<std::vector<CellOffset>>& scans)
    : first_{0} {
  for (const auto& scan : scans) first_.push_back(first_.back() + scan.size());
  shifts_.reserve(first_.back());
  for (const auto& scan : scans) {
    const std::size_t step = mixing_step(scan.size());
    for (std::size_t i = 0; i < scan.size(); ++i) {
      const CellOffset& o = scan[i * step % scan.size()];
      shifts_.push_back(level.layout().shift(o.dx, o.dy));
    }
  }
}

TileScore tile_sums(const PooledField& level, const Tile& tile,
                    std::span<const std::int32_t> shifts, int least) {
  assert(shifts.size() <= 256);
  static_assert(PooledLayout::kTileRows == 2);
  constexpr std::size_t kBlock = 8;  // Points from one check to the next.
  const std::uint8_t* base = level.tile(tile.column, tile.row);
  const std::ptrdiff_t stride = level.layout().stride;
  Sums total;
  TileScore score;
  while (score.points < shifts.size()) {
    const std::size_t end = std::min(score.points + kBlock, shifts.size());
    for (; score.points < end; ++score.points) {
      const std::uint8_t* lower = base + shifts[score.points];
      total.add(lower, lower + stride);
    }
    const auto left = static_cast<int>(shifts.size() - end);
    if (!total.any_reaches(least - left * kByteLimit)) break;
  }
  for (std::size_t pair = 0; pair < score.sums.size() / 2; ++pair) {
    score.sums[2 * pair] = total.even[pair];
    score.sums[2 * pair + 1] = total.odd[pair];
  }
  return score;
}

}  // namespace castaway::localization
