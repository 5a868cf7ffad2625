/// Memory layout of a pooled field: its nodes in tiles, and its bytes by phase.
#pragma once

#include <cstddef>
#include <cstdint>

namespace castaway::localization {

/// Sizes of one level. Nodes are squares of `edge` x `edge` cells in tiles of 8 x 2, with padding
/// on every side. The bytes of all nodes shifted by the same (dx mod edge, dy mod 2 edge), a phase,
/// are stored together, and the two rows of a tile column by column: the 16 bytes of a tile are
/// adjacent at every shift. Every byte is therefore stored twice, in a lower and an upper row.
struct PooledLayout {
  static constexpr int kTileColumns = 8;
  static constexpr int kTileRows = 2;

  /// Layout for a field of `width` x `height` cells with `padding` >= 1 cells on every side. Nodes
  /// have an edge of 2^`node_level` cells.
  PooledLayout(int width, int height, int padding, int node_level);

  int level;                  ///< Binary logarithm of the edge.
  int edge;                   ///< [cells] Edge of a node.
  int reach;                  ///< [cells] Exclusive limit of shifts.
  int tile_columns;           ///< [tiles]
  int tile_rows;              ///< [tiles]
  int padding_columns;        ///< [nodes] On the left and on the right.
  int padding_rows;           ///< [tiles] Below and above.
  std::ptrdiff_t stride;      ///< [bytes] From one row of tiles to the next.
  std::ptrdiff_t phase_size;  ///< [bytes] All nodes of one phase.

  /// Number of phases.
  [[nodiscard]] int phases() const { return kTileRows * edge * edge; }
  /// [bytes] Offset of a tile, without shift.
  [[nodiscard]] std::ptrdiff_t tile_offset(int column, int row) const {
    return (row + padding_rows) * stride + kTileRows * (kTileColumns * column + padding_columns);
  }
  /// Index of a tile, row by row.
  [[nodiscard]] std::size_t tile_index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(tile_columns) +
           static_cast<std::size_t>(column);
  }
  /// [bytes] Offset from a tile to its bytes shifted by (dx, dy) cells, |d| < `reach`.
  [[nodiscard]] std::int32_t shift(int dx, int dy) const {
    const int columns = dx >> level;  // Rounded down, as is `rows`.
    const int rows = dy >> (level + 1);
    const int phase = ((dy & (kTileRows * edge - 1)) << level) + (dx & (edge - 1));
    return phase * static_cast<std::int32_t>(phase_size) +
           rows * static_cast<std::int32_t>(stride) + kTileRows * columns;
  }
};

}  // namespace castaway::localization
