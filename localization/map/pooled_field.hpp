/// A byte field in which every node holds the maximum of a square of cells: an upper bound for the
/// score of any end point in that square.
///
/// The sliding-window maximum follows W. Hess, D. Kohler, H. Rapp, D. Andor, "Real-Time Loop
/// Closure in 2D LIDAR SLAM", ICRA 2016, section V-B. We store it by phase, so that the bounds of
/// neighbouring nodes are adjacent in memory at every level, like the scores at the finest.
#pragma once

#include "localization/map/byte_field.hpp"

namespace castaway::localization {

/// One level of a pyramid. Node (X, Y) covers the cells `[edge X, edge (X + 1))` x `[edge Y, edge
/// (Y + 1))`; shifted by (dx, dy) cells, its byte is the maximum of the shifted square.
///
/// Nodes are scored in tiles of 8 x 2: tile (i, j) has the nodes 8 i ... 8 i + 7 of the rows 2 j
/// and 2 j + 1.
class PooledField {
 public:
  static constexpr int kTileColumns = 8;
  static constexpr int kTileRows = 2;

  /// `edge` >= 1 [cells]; an edge of 1 gives the field itself.
  PooledField(const ByteField& field, int edge);

  [[nodiscard]] int edge() const { return edge_; }
  [[nodiscard]] int tile_columns() const { return tile_columns_; }
  [[nodiscard]] int tile_rows() const { return tile_rows_; }
  /// Bytes from one row of nodes to the next.
  [[nodiscard]] std::ptrdiff_t stride() const { return stride_; }
  /// [cells] Exclusive limit of shifts.
  [[nodiscard]] int reach() const { return reach_; }
  /// The byte of a tile's first node, without shift.
  [[nodiscard]] const std::uint8_t* tile(int column, int row) const {
    return bytes_.data() + (kTileRows * row + padding_) * stride_ + kTileColumns * column +
           padding_;
  }
  /// Offset from a node's byte to that of the node shifted by (dx, dy) cells, |d| < `reach`.
  /// [bytes]
  [[nodiscard]] std::int32_t shift(int dx, int dy) const;
  /// Bit 8 r + c is set if node (c, r) of the tile covers a free cell.
  [[nodiscard]] unsigned free_nodes(int column, int row) const {
    return free_[static_cast<std::size_t>(row) * static_cast<std::size_t>(tile_columns_) +
                 static_cast<std::size_t>(column)];
  }

 private:
  void pool(const ByteField& field);
  void find_free_nodes(const ByteField& field);

  int edge_;
  int reach_;
  int tile_columns_;
  int tile_rows_;
  int padding_;  ///< [nodes] On every side.
  std::ptrdiff_t stride_;
  std::ptrdiff_t phase_size_;  ///< Bytes of all nodes of one phase.
  std::vector<std::uint8_t> bytes_;
  std::vector<std::uint16_t> free_;
};

}  // namespace castaway::localization
