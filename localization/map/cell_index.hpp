/// Conversion of cell coordinates to indices that never overflows.
#pragma once

namespace castaway::localization {

/// Beyond any grid, and small enough that the sum of two fits an int.
inline constexpr int kFarthestCell = 1 << 29;

/// Index of the cell that contains a coordinate, limited to `kFarthestCell` in both directions. NaN
/// gives the farthest cell.
template <typename Real>
[[nodiscard]] inline int cell_index(Real cells) {
  constexpr auto kFarthest = static_cast<Real>(kFarthestCell);
  const Real below = cells < kFarthest ? cells : kFarthest;  // Also for NaN.
  const Real limited = below > -kFarthest ? below : -kFarthest;
  const int towards_zero = static_cast<int>(limited);
  return static_cast<Real>(towards_zero) > limited ? towards_zero - 1 : towards_zero;
}

}  // namespace castaway::localization
