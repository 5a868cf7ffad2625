/// A function of the distance to the nearest wall, tabulated per cell and interpolated between cell
/// centres.
#pragma once

#include <functional>
#include <vector>

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

 private:
  static float clamp(float value, float max) {
    const float below = value < max ? value : max;  // Also for NaN.
    return below > 0.0F ? below : 0.0F;
  }
  GridFrame frame_;
  std::ptrdiff_t stride_;
  float max_u_;
  float max_v_;
  std::vector<float> values_;
};

}  // namespace castaway::localization
