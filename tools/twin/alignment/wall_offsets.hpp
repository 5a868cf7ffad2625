/// Where the walls of a map reflect beams, as learned from a log.
#pragma once

#include <vector>

#include "localization/map/occupancy_grid.hpp"

namespace castaway::testbed {

/// Distances of the walls' surfaces behind the borders of their cells: a map states a wall within a
/// cell's width, and many scans state it within millimetres.
class WallOffsets {
 public:
  /// `usual` [m]: the offset of cells without measurements.
  WallOffsets(const localization::GridFrame& frame, double usual);

  /// Adds a measurement of the surface of a cell, by its index. [m]
  void add(std::size_t cell, double offset);
  /// The offset of a cell: the mean of its measurements, drawn towards the usual one if they are
  /// few. [m]
  [[nodiscard]] double at(std::size_t cell) const;
  [[nodiscard]] double usual() const { return usual_; }

 private:
  double usual_;
  std::vector<float> sums_;
  std::vector<float> counts_;
};

}  // namespace castaway::testbed
