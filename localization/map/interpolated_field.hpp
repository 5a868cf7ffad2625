/// A function of the distance to the nearest wall, tabulated per cell and interpolated between cell
/// centres.
#pragma once

#include <cstring>
#include <functional>
#include <vector>

#include "localization/geometry/four_floats.hpp"
#include "localization/map/distance_field.hpp"

namespace castaway::localization {

/// Values at cell centres with a border of two cells, so that a lookup needs one clamp and no
/// branch.
class InterpolatedField {
 public:
  /// Tabulates `f(distance [m])`; off the map it is `f(distances.max_distance())`.
  InterpolatedField(const DistanceField& distances, const std::function<double(double)>& f);

  [[nodiscard]] const GridFrame& frame() const { return frame_; }

  /// Bilinear value at a point in the grid's frame, given in cells (`p_grid / resolution`).
  [[nodiscard]] float at_cells(float x, float y) const {
    const float u = clamp(x + 1.5F, max_u_);
    const float v = clamp(y + 1.5F, max_v_);
    const int column = static_cast<int>(u);
    const int row = static_cast<int>(v);
    const float du = u - static_cast<float>(column);
    const float dv = v - static_cast<float>(row);
    const float* p = values_.data() + static_cast<std::ptrdiff_t>(row) * stride_ + column;
    const float below = p[0] + du * (p[1] - p[0]);
    const float above = p[stride_] + du * (p[stride_ + 1] - p[stride_]);
    return below + dv * (above - below);
  }

  /// The values at four points, to the bit those of `at_cells` of each.
  [[nodiscard]] FourFloats at_cells(FourFloats x, FourFloats y) const {
    const FourFloats u = clamp(x + 1.5F, max_u_);
    const FourFloats v = clamp(y + 1.5F, max_v_);
    const FourInts column = truncate(u);
    const FourInts row = truncate(v);
    const FourFloats du = u - to_floats(column);
    const FourFloats dv = v - to_floats(row);
    const float* p[4];
    for (int i = 0; i < 4; ++i) {
      p[i] = values_.data() + static_cast<std::ptrdiff_t>(row[i]) * stride_ + column[i];
    }
    const Neighbours lower = neighbours(p, 0);
    const Neighbours upper = neighbours(p, stride_);
    const FourFloats below = lower.left + du * (lower.right - lower.left);
    const FourFloats above = upper.left + du * (upper.right - upper.left);
    return below + dv * (above - below);
  }

 private:
  /// Values at the cell centres left and right of four points.
  struct Neighbours {
    FourFloats left, right;
  };
  using TwoPairs = double __attribute__((vector_size(4 * sizeof(float))));

  /// Those `offset` values behind four places; the two of a place are read at once.
  static Neighbours neighbours(const float* const (&p)[4], std::ptrdiff_t offset) {
    const auto pair = [offset](const float* place) {
      double bytes = 0.0;
      std::memcpy(&bytes, place + offset, sizeof bytes);
      return bytes;
    };
    const TwoPairs first{pair(p[0]), pair(p[1])};
    const TwoPairs last{pair(p[2]), pair(p[3])};
    FourFloats a;
    FourFloats b;
    std::memcpy(&a, &first, sizeof a);
    std::memcpy(&b, &last, sizeof b);
    return {__builtin_shufflevector(a, b, 0, 2, 4, 6), __builtin_shufflevector(a, b, 1, 3, 5, 7)};
  }

  GridFrame frame_;
  std::ptrdiff_t stride_;
  float max_u_;
  float max_v_;
  std::vector<float> values_;
};

}  // namespace castaway::localization
