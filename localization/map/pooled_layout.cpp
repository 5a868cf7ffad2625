#include "localization/map/pooled_layout.hpp"

#include <cassert>

namespace castaway::localization {
namespace {

int blocks_of(int value, int by) { return (value + by - 1) / by; }

}  // namespace

PooledLayout::PooledLayout(int width, int height, int padding, int node_edge)
    : edge(node_edge),
      reach(padding),
      tile_columns(blocks_of(width, edge * kTileColumns)),
      tile_rows(blocks_of(height, edge * kTileRows)),
      padding_nodes(blocks_of(padding, edge)),
      stride(tile_columns * kTileColumns + 2 * padding_nodes),
      phase_size(stride * (tile_rows * kTileRows + 2 * padding_nodes)) {
  assert(edge >= 1);
}

std::int32_t PooledLayout::shift(int dx, int dy) const {
  const int X = (dx + padding_nodes * edge) / edge - padding_nodes;  // Rounded down.
  const int Y = (dy + padding_nodes * edge) / edge - padding_nodes;
  const int phase = (dy - Y * edge) * edge + (dx - X * edge);
  return static_cast<std::int32_t>(phase * phase_size + Y * stride + X);
}

}  // namespace castaway::localization
