/// From coordinates in cells to a cell's index, for any number.
#pragma once

#include <cmath>

namespace castaway::sim {

/// Farther out than any grid reaches, and near enough that sums of two stay in the range of int.
inline constexpr int kFarthestCell = 1 << 29;

/// The cell that a coordinate lies in: rounded down, at most `kFarthestCell` either way. What is no
/// number lies in the farthest cell.
template <typename Real>
[[nodiscard]] inline int cell_index(Real cells) {
  constexpr auto kFarthest = static_cast<Real>(kFarthestCell);
  const Real below = cells < kFarthest ? cells : kFarthest;  // Also for NaN.
  return static_cast<int>(std::floor(below > -kFarthest ? below : -kFarthest));
}

}  // namespace castaway::sim
