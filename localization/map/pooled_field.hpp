/// A byte field in which every node holds the maximum of a square of cells: an upper bound for the
/// score of any end point in that square.
///
/// The sliding-window maximum follows W. Hess, D. Kohler, H. Rapp, D. Andor, "Real-Time Loop
/// Closure in 2D LIDAR SLAM", ICRA 2016, section V-B. We store it by phase, so that the bounds of
/// neighbouring nodes are adjacent in memory at every level, like the scores at the finest.
#pragma once

#include <cstdint>
#include <vector>

#include "localization/map/byte_field.hpp"
#include "localization/map/pooled_layout.hpp"

namespace castaway::localization {

/// One level of a pyramid. Node (X, Y) covers the cells `[edge X, edge (X + 1))` x `[edge Y, edge
/// (Y + 1))`; shifted by (dx, dy) cells, its byte is the maximum of the shifted square.
///
/// Nodes are scored in tiles of 8 x 2: tile (i, j) has the nodes 8 i ... 8 i + 7 of the rows 2 j
/// and 2 j + 1.
class PooledField {
 public:
  /// `edge` >= 1 [cells]; an edge of 1 gives the field itself.
  PooledField(const ByteField& field, int edge);

  [[nodiscard]] const PooledLayout& layout() const { return layout_; }
  /// The byte of a tile's first node, without shift.
  [[nodiscard]] const std::uint8_t* tile(int column, int row) const {
    return bytes_.data() + layout_.tile_offset(column, row);
  }
  /// Bit 8 r + c is set if node (c, r) of the tile covers a free cell.
  [[nodiscard]] unsigned free_nodes(int column, int row) const {
    return free_[layout_.tile_index(column, row)];
  }

 private:
  PooledLayout layout_;
  std::vector<std::uint8_t> bytes_;
  std::vector<std::uint16_t> free_;  ///< For each tile.
};

}  // namespace castaway::localization
