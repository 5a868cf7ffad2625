#include "localization/map/pooled_layout.hpp"

#include <cassert>

namespace castaway::localization {
namespace {

int blocks_of(int value, int by) { return (value + by - 1) / by; }

}  // namespace

PooledLayout::PooledLayout(int width, int height, int padding, int node_level)
    : level(node_level),
      edge(1 << level),
      reach(padding),
      tile_columns(blocks_of(width, edge * kTileColumns)),
      tile_rows(blocks_of(height, edge * kTileRows)),
      padding_columns(blocks_of(padding, edge)),
      padding_rows(blocks_of(padding, edge * kTileRows)),
      stride(kTileRows * (tile_columns * kTileColumns + 2 * padding_columns)),
      phase_size(stride * (tile_rows + 2 * padding_rows)) {
  assert(level >= 0 && padding >= 1);
}

}  // namespace castaway::localization
