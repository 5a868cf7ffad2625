/// A coarse likelihood field of bytes for searching: the best value within every coarse cell.
#pragma once

#include <cstdint>
#include <vector>

#include "localization/map/distance_field.hpp"

namespace castaway::localization {

/// Parameters of a byte field.
struct ByteFieldConfig {
  double resolution = 0.2;  ///< [m] Edge of a coarse cell; rounded to a multiple of the map's.
  /// [m] Bytes are `255 exp(-d^2 / 2 sigma^2)` of the least distance d in the cell.
  double sigma = 0.15;
  /// [m] Border of zeros on all sides, so that end points need no bounds check.
  double padding = 40.0;
};

/// Bytes and free cells at the coarse resolution.
class ByteField {
 public:
  ByteField(const OccupancyGrid& grid, const DistanceField& distances,
            const ByteFieldConfig& config);
  /// Takes bytes and free cells, row by row, and `padding` coarse cells on every side.
  ByteField(const GridFrame& frame, int padding, const std::vector<std::uint8_t>& bytes,
            std::vector<bool> free);

  /// The coarse cells without padding; cell (0, 0) starts at the map's lower left corner.
  [[nodiscard]] const GridFrame& frame() const { return frame_; }
  /// [coarse cells] Padding on every side.
  [[nodiscard]] int padding() const { return padding_; }
  /// Bytes from one row to the next.
  [[nodiscard]] std::ptrdiff_t stride() const { return stride_; }
  /// The byte of a coarse cell; valid within the padding.
  [[nodiscard]] const std::uint8_t* cell(int column, int row) const {
    return bytes_.data() + (row + padding_) * stride_ + (column + padding_);
  }
  /// True if base may be in a coarse cell: it contains a free cell of the map.
  [[nodiscard]] bool is_free(int column, int row) const {
    return free_[frame_.index({column, row})];
  }
  /// For each coarse cell, row by row.
  [[nodiscard]] const std::vector<bool>& free() const { return free_; }

 private:
  GridFrame frame_;
  int padding_ = 0;
  std::ptrdiff_t stride_ = 0;
  std::vector<std::uint8_t> bytes_;
  std::vector<bool> free_;
};

}  // namespace castaway::localization
