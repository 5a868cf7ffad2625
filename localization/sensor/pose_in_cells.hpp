/// A pose prepared for looking up many points in a grid.
#pragma once

#include <cmath>

#include "localization/map/occupancy_grid.hpp"

namespace castaway::localization {

/// Maps points from base [m] to the grid's frame [cells]; sine and cosine are computed once.
class PoseInCells {
 public:
  PoseInCells(const GridFrame& frame, const SE2& T_map_base) {
    const SE2 T_grid_base = frame.T_map_grid.inverse() * T_map_base;
    const double scale = 1.0 / frame.resolution;
    cos_ = static_cast<float>(std::cos(T_grid_base.yaw) * scale);
    sin_ = static_cast<float>(std::sin(T_grid_base.yaw) * scale);
    x_ = static_cast<float>(T_grid_base.x * scale);
    y_ = static_cast<float>(T_grid_base.y * scale);
  }
  [[nodiscard]] float x(float px, float py) const { return x_ + cos_ * px - sin_ * py; }
  [[nodiscard]] float y(float px, float py) const { return y_ + sin_ * px + cos_ * py; }

 private:
  float cos_, sin_, x_, y_;
};

}  // namespace castaway::localization
