/// Upper bounds for the hits of a scan (eq. 9), many cells at a time: what a search need not
/// evaluate.
///
/// A beam whose end point is k cells from the nearest wall, diagonal steps included, has an error
/// of at least k cells. For base at the centre of a cell, the end points of a scan lie in the same
/// cells relative to base, so that a bound is a sum of bytes.
#pragma once

#include <cstdint>
#include <vector>

#include "localization/matching/search_space.hpp"
#include "localization/paper/ray_local_model.hpp"

namespace castaway::localization {

/// Cells of a row, from `first` to before `end`.
struct CellRun {
  int row = 0;
  int first = 0;
  int end = 0;
};

/// Cells of a scan's end points relative to the cell of base, for base at the centre of any cell
/// with this yaw in map [rad]. A point within rounding errors of a border counts in the cells on
/// both sides. Points are left out if they lie far off the map from all of its cells.
std::vector<CellOffset> end_cells(const RayLocalModel& model, const ScanPoints& points,
                                  double yaw_map);

/// Bounds for one map: sums over the cells of end points.
class HitBounds {
 public:
  explicit HitBounds(const RayLocalModel& model);

  /// Least bound of poses with this quality (share of hits among this number of beams) or a higher
  /// one.
  [[nodiscard]] std::int64_t least(double quality, std::size_t beams) const;
  /// Bound for base in a cell of the map.
  [[nodiscard]] std::int64_t at(const std::vector<CellOffset>& ends,
                                const Eigen::Vector2i& cell) const;
  /// Bounds for base in every cell of a run.
  [[nodiscard]] std::vector<std::uint32_t> in_run(const std::vector<CellOffset>& ends,
                                                  const CellRun& run) const;

 private:
  int padding_;
  int columns_;
  int rows_;
  int far_;                          ///< Bound of a beam that ends far from all walls.
  std::vector<std::uint8_t> bytes_;  ///< Bounds in excess of `far_`, with padding on all sides.
};

}  // namespace castaway::localization
