#include "localization/map/pooled_field.hpp"

#include <algorithm>

namespace castaway::localization {
namespace {

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

/// The maxima of all nodes at all shifts.
std::vector<std::uint8_t> pool(const ByteField& field, const PooledLayout& layout) {
  const int edge = layout.edge;
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(layout.phase_size * edge * edge), 0);
  const int columns = static_cast<int>(layout.stride);
  const int rows = static_cast<int>(layout.phase_size / layout.stride);
  std::uint8_t* byte = bytes.data();
  for (int phase = 0; phase < edge * edge; ++phase) {
    for (int Y = 0; Y < rows; ++Y) {
      for (int X = 0; X < columns; ++X) {
        *byte++ = best_of_square(field, (X - layout.padding_nodes) * edge + phase % edge,
                                 (Y - layout.padding_nodes) * edge + phase / edge, edge);
      }
    }
  }
  return bytes;
}

/// The bits of the free nodes of every tile.
std::vector<std::uint16_t> find_free_nodes(const ByteField& field, const PooledLayout& layout) {
  std::vector<std::uint16_t> free(layout.tile_index(0, layout.tile_rows), 0);
  for (int row = 0; row < field.frame().height; ++row) {
    for (int column = 0; column < field.frame().width; ++column) {
      if (!field.is_free(column, row)) continue;
      const int X = column / layout.edge;
      const int Y = row / layout.edge;
      std::uint16_t& tile =
          free[layout.tile_index(X / PooledLayout::kTileColumns, Y / PooledLayout::kTileRows)];
      const int node =
          Y % PooledLayout::kTileRows * PooledLayout::kTileColumns + X % PooledLayout::kTileColumns;
      tile = static_cast<std::uint16_t>(tile | 1U << static_cast<unsigned>(node));
    }
  }
  return free;
}

}  // namespace

PooledField::PooledField(const ByteField& field, int edge)
    : layout_(field.frame().width, field.frame().height, field.padding(), edge),
      bytes_(pool(field, layout_)),
      free_(find_free_nodes(field, layout_)) {}

}  // namespace castaway::localization
