/// Upper bounds for the hits of a scan (eq. 9), many cells at a time: what a search need not
/// evaluate.
///
/// A beam whose end point is k cells from the nearest wall, diagonal steps included, has an error
/// of at least k cells. A bound is the sum of a byte for each end point (`RaysAtYaw::ends`).
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
