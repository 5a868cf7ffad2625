/// Poses prepared for looking up many points in a map.
#pragma once

#include <cmath>
#include <cstddef>

#include <Eigen/Geometry>

#include "localization/map/occupancy_grid.hpp"
#include "localization/sensor/four_points.hpp"
#include "localization/sensor/scan_points.hpp"

namespace castaway::localization {

/// A grid's frame prepared for many poses.
class MapToGrid {
 public:
  explicit MapToGrid(const GridFrame& frame)
      : T_grid_map_(frame.T_map_grid.inverse()),
        cos_(std::cos(T_grid_map_.yaw)),
        sin_(std::sin(T_grid_map_.yaw)),
        cells_per_m_(1.0 / frame.resolution) {}

  /// `T_grid_base`
  [[nodiscard]] SE2 operator()(const SE2& T_map_base) const {
    return {T_grid_map_.x + cos_ * T_map_base.x - sin_ * T_map_base.y,
            T_grid_map_.y + sin_ * T_map_base.x + cos_ * T_map_base.y,
            wrap_angle(T_grid_map_.yaw + T_map_base.yaw)};
  }
  [[nodiscard]] double cells_per_m() const { return cells_per_m_; }

 private:
  SE2 T_grid_map_;
  double cos_, sin_;
  double cells_per_m_;
};

/// Maps points from base [m] to the grid's frame [cells]; sine and cosine are computed once.
class PoseInCells {
 public:
  PoseInCells(const GridFrame& frame, const SE2& T_map_base)
      : PoseInCells(MapToGrid(frame), T_map_base) {}
  PoseInCells(const MapToGrid& to_grid, const SE2& T_map_base) {
    const SE2 T_grid_base = to_grid(T_map_base);
    const double scale = to_grid.cells_per_m();
    cos_ = static_cast<float>(std::cos(T_grid_base.yaw) * scale);
    sin_ = static_cast<float>(std::sin(T_grid_base.yaw) * scale);
    x_ = static_cast<float>(T_grid_base.x * scale);
    y_ = static_cast<float>(T_grid_base.y * scale);
  }
  /// `Number`: float or FourFloats.
  template <typename Number>
  [[nodiscard]] Number x(Number px, Number py) const {
    return x_ + cos_ * px - sin_ * py;
  }
  template <typename Number>
  [[nodiscard]] Number y(Number px, Number py) const {
    return y_ + sin_ * px + cos_ * py;
  }

 private:
  float cos_, sin_, x_, y_;
};

/// Maps points of scans from base to map, in single precision.
class PoseInVolume {
 public:
  explicit PoseInVolume(const Eigen::Isometry3d& T_map_base)
      : R_(T_map_base.linear().cast<float>()), t_(T_map_base.translation().cast<float>()) {}

  /// End of beam `i` in map. [m]
  [[nodiscard]] Eigen::Vector3f end(const ScanPoints& points, std::size_t i) const {
    return R_ * Eigen::Vector3f(points.x[i], points.y[i], points.z[i]) + t_;
  }
  /// Four ends in map. [m]
  [[nodiscard]] FourPoints operator*(const FourPoints& p_base) const {
    return transform(R_, t_, p_base);
  }
  /// Where beam `i` begins. [m]
  [[nodiscard]] Eigen::Vector3f origin(const ScanPoints& points, std::size_t i) const {
    return R_ * Eigen::Vector3f(points.origin_x[i], points.origin_y[i], points.origin_z[i]) + t_;
  }

 private:
  Eigen::Matrix3f R_;
  Eigen::Vector3f t_;
};

}  // namespace castaway::localization
