#include "localization/map/pooled_field.hpp"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <utility>

namespace castaway::localization {
namespace {

int blocks_of(int value, int by) { return (value + by - 1) / by; }

/// Bytes of all cells that a layout covers, row by row: those of its nodes and their padding, and
/// of one more row of nodes. Bytes outside of the field are 0.
struct Plane {
  Plane(const ByteField& field, const PooledLayout& layout);

  std::ptrdiff_t width;
  std::vector<std::uint8_t> bytes;
};

Plane::Plane(const ByteField& field, const PooledLayout& layout)
    : width(layout.stride / PooledLayout::kTileRows * layout.edge) {
  constexpr int kRows = PooledLayout::kTileRows;
  const std::ptrdiff_t rows = kRows * (layout.phase_size / layout.stride) + 1;
  bytes.assign(static_cast<std::size_t>(rows * layout.edge * width), 0);
  for (int row = 0; row < field.frame().height; ++row) {
    const std::uint8_t* from = field.cell(0, row);
    const std::ptrdiff_t to = (row + layout.padding_rows * kRows * layout.edge) * width +
                              layout.padding_columns * layout.edge;
    std::copy(from, from + field.frame().width, bytes.begin() + to);
  }
}

/// Replaces the maxima of squares of `edge` by those of squares of twice the edge. A square is
/// stored at its first cell. Needs padding on the left of twice the edge.
void double_edge(Plane& plane, std::ptrdiff_t edge) {
  for (const std::ptrdiff_t ahead : {edge, edge * plane.width}) {
    const std::ptrdiff_t end = std::ssize(plane.bytes) - ahead;
    std::uint8_t* byte = plane.bytes.data();
    for (std::ptrdiff_t i = 0; i < end; ++i) byte[i] = std::max(byte[i], byte[i + ahead]);
  }
}

/// Sorts the bytes of a plane by phase.
std::vector<std::uint8_t> sort_by_phase(const Plane& plane, const PooledLayout& layout) {
  std::vector<std::uint8_t> sorted(static_cast<std::size_t>(layout.phase_size * layout.phases()));
  const std::ptrdiff_t above = layout.edge * plane.width;  // To the upper row of a tile.
  const std::ptrdiff_t tile_rows = layout.phase_size / layout.stride;
  std::uint8_t* to = sorted.data();
  for (std::ptrdiff_t phase = 0; phase < layout.phases(); ++phase) {
    const std::uint8_t* first =
        plane.bytes.data() + phase / layout.edge * plane.width + phase % layout.edge;
    for (std::ptrdiff_t row = 0; row < tile_rows; ++row) {
      const std::uint8_t* from = first + PooledLayout::kTileRows * above * row;
      for (std::ptrdiff_t column = 0; column < plane.width; column += layout.edge) {
        *to++ = from[column];
        *to++ = from[column + above];
      }
    }
  }
  return sorted;
}

/// The deficits of all nodes at all shifts.
std::vector<std::uint8_t> pool(const ByteField& field, const PooledLayout& layout, int step) {
  Plane plane(field, layout);
  for (int edge = 1; edge < layout.edge; edge *= 2) double_edge(plane, edge);
  for (std::uint8_t& byte : plane.bytes) {
    byte = static_cast<std::uint8_t>((PooledField::kBest - byte) / step);
  }
  return sort_by_phase(plane, layout);
}

/// The bits of the nodes of every tile that cover free cells.
class FreeNodes {
 public:
  explicit FreeNodes(const PooledLayout& layout)
      : layout_(layout), tiles_(layout.tile_index(0, layout.tile_rows), 0) {}

  void add(const Eigen::Vector2i& free_cell) {
    const int X = free_cell.x() >> layout_.level;
    const int Y = free_cell.y() >> layout_.level;
    std::uint16_t& tile =
        tiles_[layout_.tile_index(X / PooledLayout::kTileColumns, Y / PooledLayout::kTileRows)];
    const int node =
        Y % PooledLayout::kTileRows * PooledLayout::kTileColumns + X % PooledLayout::kTileColumns;
    tile = static_cast<std::uint16_t>(tile | 1U << static_cast<unsigned>(node));
  }
  [[nodiscard]] std::vector<std::uint16_t> take() { return std::move(tiles_); }

 private:
  const PooledLayout& layout_;
  std::vector<std::uint16_t> tiles_;
};

std::vector<std::uint16_t> find_free_nodes(const ByteField& field, const PooledLayout& layout) {
  FreeNodes nodes(layout);
  const GridFrame& frame = field.frame();
  for (int row = 0; row < frame.height; ++row) {
    for (int column = 0; column < frame.width; ++column) {
      if (field.free()[frame.index({column, row})]) nodes.add({column, row});
    }
  }
  return nodes.take();
}

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

PooledField::PooledField(const ByteField& field, int level)
    : layout_(field.frame().width, field.frame().height, field.padding(), level),
      deficits_(std::make_shared<const std::vector<std::uint8_t>>(pool(field, layout_, step()))),
      first_deficit_(deficits_->data()),
      free_(find_free_nodes(field, layout_)) {}

PooledField PooledField::with_free(std::span<const Eigen::Vector2i> cells) const {
  PooledField other = *this;
  FreeNodes nodes(layout_);
  for (const Eigen::Vector2i& cell : cells) nodes.add(cell);
  other.free_ = nodes.take();
  return other;
}

}  // namespace castaway::localization
