/// A byte field in which every node holds the maximum of a square of cells: an upper bound for the
/// score of any end point in that square.
///
/// The sliding-window maximum follows W. Hess, D. Kohler, H. Rapp, D. Andor, "Real-Time Loop
/// Closure in 2D LIDAR SLAM", ICRA 2016, section V-B. We store it by phase, so that the bounds of
/// neighbouring nodes are adjacent in memory at every level, like the scores at the finest, and
/// quantised at the coarse levels, so that the bytes of 16 end points can be summed in bytes.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "localization/map/byte_field.hpp"
#include "localization/map/pooled_layout.hpp"

namespace castaway::localization {

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
