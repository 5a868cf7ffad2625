/// A byte field in which every node holds the maximum of a square of cells: an upper bound for the
/// score of any end point in that square.
///
/// The sliding-window maximum follows W. Hess, D. Kohler, H. Rapp, D. Andor, "Real-Time Loop
/// Closure in 2D LIDAR SLAM", ICRA 2016, section V-B. We store it by phase, so that the bounds of
/// neighbouring nodes are adjacent in memory at every level, like the scores at the finest, and
/// quantised at the coarse levels, so that the bytes of 16 end points can be summed in bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "localization/map/byte_field.hpp"

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

/// One level of a pyramid. Node (X, Y) covers the cells `[edge X, edge (X + 1))` x `[edge Y, edge
/// (Y + 1))`; shifted by (dx, dy) cells, its value is the maximum of the shifted square. Stored is
/// its deficit, `(255 - value) / step` rounded down.
///
/// Nodes are scored in tiles of 8 x 2: tile (i, j) has the nodes 8 i ... 8 i + 7 of the rows 2 j
/// and 2 j + 1.
class PooledField {
 public:
  static constexpr int kBest = 255;       ///< Value of a perfect fit.
  static constexpr int kCoarseStep = 17;  ///< A divisor of 255: deficits of 0 and 255 are exact.

  /// `level` >= 0: nodes have an edge of 2^level cells. Level 0 is the field itself.
  PooledField(const ByteField& field, int level);
  /// The same values with these free cells (within the field) instead; both share the memory of
  /// the values.
  [[nodiscard]] PooledField with_free(std::span<const Eigen::Vector2i> cells) const;

  [[nodiscard]] const PooledLayout& layout() const { return layout_; }
  /// Value of a deficit of 1: 1 at level 0, `kCoarseStep` at the others.
  [[nodiscard]] int step() const { return layout_.level == 0 ? 1 : kCoarseStep; }
  /// Deficits of a tile, without shift: of node (c, r) at 2 c + r.
  [[nodiscard]] const std::uint8_t* tile(int column, int row) const {
    return first_deficit_ + layout_.tile_offset(column, row);
  }
  /// Bit 8 r + c is set if node (c, r) of the tile covers a free cell.
  [[nodiscard]] unsigned free_nodes(int column, int row) const {
    return free_[layout_.tile_index(column, row)];
  }

 private:
  PooledLayout layout_;
  std::shared_ptr<const std::vector<std::uint8_t>> deficits_;
  const std::uint8_t* first_deficit_;
  std::vector<std::uint16_t> free_;  ///< For each tile.
};

}  // namespace castaway::localization
