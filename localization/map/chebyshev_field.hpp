/// Number of cells from every cell to the nearest occupied cell, counting diagonal steps as one:
/// half the edge of the largest square around a cell that is free of walls.
#pragma once

#include <cstdint>
#include <vector>

#include "localization/map/occupancy_grid.hpp"

namespace castaway::localization {

/// Chebyshev distances. [cells]
class ChebyshevField {
 public:
  /// Distances are capped at `cap` (1 to 255), which also applies far off the map.
  ChebyshevField(const OccupancyGrid& grid, int cap);

  [[nodiscard]] int cap() const { return cap_; }
  /// Distance of a cell, on the map or off it; 0 if it is occupied.
  [[nodiscard]] int at(int column, int row) const {
    const auto c = static_cast<std::size_t>(column + cap_);  // Huge if negative.
    const auto r = static_cast<std::size_t>(row + cap_);
    return c < columns_ && r < rows_ ? values_[r * columns_ + c] : cap_;
  }

 private:
  int cap_;
  // Padded by `cap_` cells on all sides, beyond which all distances are capped.
  std::size_t columns_;
  std::size_t rows_;
  std::vector<std::uint8_t> values_;
};

}  // namespace castaway::localization
