/// Distances to the nearest wall in bytes, for stepping along rays: a quarter of the memory of a
/// `DistanceField`, so that the rays of a large map stay in the cache.
#pragma once

#include <cstdint>
#include <vector>

#include "localization/map/distance_field.hpp"

namespace castaway::localization {

/// Distances of the cells to the nearest occupied cell, rounded down to half cells, at most 127.5
/// cells.
class WallClearance {
 public:
  explicit WallClearance(const DistanceField& distances);

  [[nodiscard]] const GridFrame& frame() const { return frame_; }
  /// [half cells] Clearance of a cell of the map; 0 on a wall.
  [[nodiscard]] int half_cells(int column, int row) const {
    return values_[frame_.index({column, row})];
  }

 private:
  GridFrame frame_;
  std::vector<std::uint8_t> values_;
};

}  // namespace castaway::localization
