/// Memory layout of a pooled field: its nodes in tiles, and its bytes by phase.
#pragma once

#include <cstddef>
#include <cstdint>

namespace castaway::localization {

/// Sizes of one level. Nodes are squares of `edge` x `edge` cells in tiles of 8 x 2, with padding
/// on every side. The bytes of all nodes shifted by the same (dx mod edge, dy mod edge), a phase,
/// are stored together.
struct PooledLayout {
  static constexpr int kTileColumns = 8;
  static constexpr int kTileRows = 2;

  /// Layout for a field of `width` x `height` cells with `padding` cells on every side. Requires
  /// `node_edge` >= 1.
  PooledLayout(int width, int height, int padding, int node_edge);

  int edge;                   ///< [cells] Edge of a node.
  int reach;                  ///< [cells] Exclusive limit of shifts.
  int tile_columns;           ///< [tiles]
  int tile_rows;              ///< [tiles]
  int padding_nodes;          ///< [nodes] On every side.
  std::ptrdiff_t stride;      ///< [bytes] From one row of nodes to the next.
  std::ptrdiff_t phase_size;  ///< [bytes] All nodes of one phase.

  /// [bytes] Offset of a tile's first node, without shift.
  [[nodiscard]] std::ptrdiff_t tile_offset(int column, int row) const {
    return (kTileRows * row + padding_nodes) * stride + kTileColumns * column + padding_nodes;
  }
  /// Index of a tile, row by row.
  [[nodiscard]] std::size_t tile_index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(tile_columns) +
           static_cast<std::size_t>(column);
  }
  /// [bytes] Offset from a node's byte to that of the node shifted by (dx, dy) cells,
  /// |d| < `reach`.
  [[nodiscard]] std::int32_t shift(int dx, int dy) const;
};

}  // namespace castaway::localization
