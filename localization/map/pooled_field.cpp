#include "localization/map/pooled_field.hpp"

#include <algorithm>
#include <cassert>

namespace castaway::localization {
namespace {

int blocks_of(int value, int by) { return (value + by - 1) / by; }

/// Largest byte of the square of cells that starts at (column, row), within the map.
std::uint8_t best_of_square(const ByteField& field, int column, int row, int edge) {
  const int columns_end = std::min(column + edge, field.frame().width);
  const int rows_end = std::min(row + edge, field.frame().height);
  std::uint8_t best = 0;
  for (int y = std::max(row, 0); y < rows_end; ++y) {
    for (int x = std::max(column, 0); x < columns_end; ++x)
      best = std::max(best, *field.cell(x, y));
  }
  return best;
}

}  // namespace

PooledField::PooledField(const ByteField& field, int edge)
    : edge_(edge),
      reach_(field.padding()),
      tile_columns_(blocks_of(field.frame().width, edge * kTileColumns)),
      tile_rows_(blocks_of(field.frame().height, edge * kTileRows)),
      padding_(blocks_of(field.padding(), edge)),
      stride_(tile_columns_ * kTileColumns + 2 * padding_),
      phase_size_(stride_ * (tile_rows_ * kTileRows + 2 * padding_)) {
  assert(edge >= 1);
  pool(field);
  find_free_nodes(field);
}

void PooledField::pool(const ByteField& field) {
  bytes_.assign(static_cast<std::size_t>(phase_size_ * edge_ * edge_), 0);
  const int columns = static_cast<int>(stride_);
  const int rows = static_cast<int>(phase_size_ / stride_);
  std::uint8_t* byte = bytes_.data();
  for (int phase = 0; phase < edge_ * edge_; ++phase) {
    for (int Y = 0; Y < rows; ++Y) {
      for (int X = 0; X < columns; ++X) {
        *byte++ = best_of_square(field, (X - padding_) * edge_ + phase % edge_,
                                 (Y - padding_) * edge_ + phase / edge_, edge_);
      }
    }
  }
}

void PooledField::find_free_nodes(const ByteField& field) {
  free_.assign(static_cast<std::size_t>(tile_columns_) * static_cast<std::size_t>(tile_rows_), 0);
  for (int row = 0; row < field.frame().height; ++row) {
    for (int column = 0; column < field.frame().width; ++column) {
      if (!field.is_free(column, row)) continue;
      const int X = column / edge_;
      const int Y = row / edge_;
      std::uint16_t& tile =
          free_[static_cast<std::size_t>(Y / kTileRows * tile_columns_ + X / kTileColumns)];
      tile = static_cast<std::uint16_t>(
          tile | 1U << static_cast<unsigned>(Y % kTileRows * kTileColumns + X % kTileColumns));
    }
  }
}

std::int32_t PooledField::shift(int dx, int dy) const {
  const int X = (dx + padding_ * edge_) / edge_ - padding_;  // rounded down
  const int Y = (dy + padding_ * edge_) / edge_ - padding_;
  const int phase = (dy - Y * edge_) * edge_ + (dx - X * edge_);
  return static_cast<std::int32_t>(phase * phase_size_ + Y * stride_ + X);
}

}  // namespace castaway::localization
