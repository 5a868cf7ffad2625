#include "localization/matching/tile_sums.hpp"

#include <cassert>
#include <utility>

namespace castaway::localization {
namespace {

/// The largest sum of deficits that leaves `least`; negative if none does.
template <int kStep>
int limit_of(std::size_t points, int least) {
  const int spare = PooledField::kBest * static_cast<int>(points) - least;
  return spare < 0 ? -1 : spare / kStep;
}

/// The deficits of a tile under some end points. Stops as soon as all are above `limit`; returns
/// the number of points summed, too. Inlined so that the sums stay in registers.
template <int kStep>
[[gnu::always_inline]] inline std::pair<DeficitSums, std::size_t> sum_deficits(
    const std::uint8_t* tile, std::span<const std::int32_t> shifts, int limit) {
  DeficitSums total;
  std::size_t points = 0;
  while (points < shifts.size()) {
    const std::size_t size = std::min(DeficitSums::kBlock, shifts.size() - points);
    if constexpr (kStep == 1) {
      total.add_fine(tile, shifts.subspan(points, size));
    } else {
      total.add_coarse(tile, shifts.subspan(points, size));
    }
    points += size;
    if (!total.any_within(limit)) break;
  }
  return {total, points};
}

/// What `deficits` leave of the sums of `points` perfect values.
template <int kStep>
TileWords sums_of(const TileWords& deficits, std::size_t points) {
  const Words8 perfect = Words8{} + static_cast<std::uint16_t>(PooledField::kBest * points);
  constexpr auto kFactor = static_cast<std::uint16_t>(kStep);
  return {perfect - deficits.lower * kFactor, perfect - deficits.upper * kFactor};
}

template <int kStep>
TileScore score_tile(const std::uint8_t* tile, std::span<const std::int32_t> shifts, int least) {
  const int limit = limit_of<kStep>(shifts.size(), least);
  const auto [deficits, points] = sum_deficits<kStep>(tile, shifts, limit);
  const TileWords sums = sums_of<kStep>(deficits.words(), shifts.size());
  TileScore score;
  static_assert(sizeof sums == sizeof score.sums);
  std::memcpy(score.sums.data(), &sums, sizeof sums);
  score.points = points;
  return score;
}

/// Ones in the words of the nodes whose bits are set.
Words8 mask_of(unsigned nodes) {
  constexpr Words8 kBits{1, 2, 4, 8, 16, 32, 64, 128};
  return static_cast<Words8>((kBits & static_cast<std::uint16_t>(nodes & 0xFFU)) == kBits);
}

/// The largest word of every child.
ChildBounds best_of_children(const TileWords& tile) {
  using Pairs = std::uint32_t __attribute__((vector_size(16)));
  const auto a = __builtin_shufflevector(tile.lower, tile.upper, 0, 1, 4, 5, 8, 9, 12, 13);
  const auto b = __builtin_shufflevector(tile.lower, tile.upper, 2, 3, 6, 7, 10, 11, 14, 15);
  const Words8 best = a > b ? a : b;
  Pairs pairs;
  std::memcpy(&pairs, &best, sizeof pairs);
  const Pairs low = pairs & 0xFFFFU;
  const Pairs high = pairs >> 16;
  const Pairs bounds = low > high ? low : high;
  return {static_cast<std::uint16_t>(bounds[0]), static_cast<std::uint16_t>(bounds[1]),
          static_cast<std::uint16_t>(bounds[2]), static_cast<std::uint16_t>(bounds[3])};
}

}  // namespace

TileScore tile_sums(const PooledField& level, const Tile& tile,
                    std::span<const std::int32_t> shifts, int least) {
  assert(shifts.size() <= 256 && least >= 0);
  const std::uint8_t* bytes = level.tile(tile.column, tile.row);
  if (level.step() == 1) return score_tile<1>(bytes, shifts, least);
  return score_tile<PooledField::kCoarseStep>(bytes, shifts, least);
}

TileBounds tile_bounds(const PooledField& level, const Tile& tile,
                       std::span<const std::int32_t> shifts, int least) {
  assert(shifts.size() <= 256 && least >= 0 && level.step() == PooledField::kCoarseStep);
  constexpr int kStep = PooledField::kCoarseStep;
  const int limit = limit_of<kStep>(shifts.size(), least);
  const auto [deficits, points] =
      sum_deficits<kStep>(level.tile(tile.column, tile.row), shifts, limit);
  const TileWords sums = sums_of<kStep>(deficits.words(), shifts.size());
  const unsigned free = level.free_nodes(tile.column, tile.row);
  return {best_of_children({sums.lower & mask_of(free), sums.upper & mask_of(free >> 8U)}), points};
}

}  // namespace castaway::localization
