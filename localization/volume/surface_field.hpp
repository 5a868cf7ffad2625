/// Distances of points from the surfaces of a 3-D map: point to plane.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <Eigen/Geometry>

#include "localization/volume/surface_patches.hpp"
#include "localization/volume/voxel_blocks.hpp"

namespace castaway::localization {

/// Each voxel near a surface stores how far its centre is from the nearest patch
/// (`SurfacePatch`), and in which direction. Within a voxel the distance changes linearly, so that
/// distances from planes are exact, however coarse the voxels, up to rounding. All points
/// of a voxel whose centre is farther than `max_distance` read as that.
class SurfaceField {
 public:
  /// Distance of a voxel's centre, and its rise per edge of a voxel along each axis; in 1/127 of
  /// the reach, and 1/127.
  struct Cell {
    std::int8_t distance = 127;
    std::int8_t x = 0;
    std::int8_t y = 0;
    std::int8_t z = 0;
  };
  /// The voxel of a point, and where in it the point is: from its corner, in its edges.
  struct Place {
    const Cell* cell;
    Eigen::Vector3f within;
  };
  /// Values of a function at 256 distances from 0 to the largest.
  using Table = std::array<float, 256>;

  /// `max_distance` [m]: larger distances read as this. @throws std::invalid_argument for an
  /// invalid map or distance, or a map with too many blocks.
  SurfaceField(const VoxelMap& map, double max_distance);

  /// Distance from a point to the nearest surface. [m]
  [[nodiscard]] float at(const Eigen::Vector3f& p_map) const {
    return resolution_ * std::min(distance(find(to_lattice(p_map))), reach_);
  }
  /// Distance from the centre of the voxel that a point is in. [m]
  [[nodiscard]] float at_point(const Eigen::Vector3f& p_map) const {
    return resolution_ * unit_ * static_cast<float>(find(to_lattice(p_map)).cell->distance);
  }
  template <typename Function>
  [[nodiscard]] Table tabulate(const Function& f) const {
    Table values{};
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] = static_cast<float>(
          f(static_cast<double>(resolution_ * reach_) * static_cast<double>(i) / 255.0));
    }
    return values;
  }

  /// For many points: rotation and scale, and translation, from base to the lattice of
  /// `VoxelBlocks`.
  struct LatticePose {
    Eigen::Matrix3f R;
    Eigen::Vector3f t;
  };
  [[nodiscard]] LatticePose lattice_pose(const Eigen::Isometry3d& T_map_base) const {
    return {per_m_ * T_map_base.linear().cast<float>(),
            to_lattice(T_map_base.translation().cast<float>())};
  }
  [[nodiscard]] Place find(const Eigen::Vector3f& p_lattice) const {
    static constexpr Cell kFar{};
    const auto place = blocks_.find(p_lattice);
    if (!place) return {&kFar, Eigen::Vector3f::Zero()};
    return {&cells_[place->voxel.block][place->voxel.voxel], place->within};
  }
  /// The value of a function at a place's distance from the nearest surface.
  [[nodiscard]] float value(const Place& place, const Table& values) const {
    return values[static_cast<std::size_t>(std::min(steps_ * distance(place) + 0.5F, 255.0F))];
  }

  [[nodiscard]] double resolution() const { return static_cast<double>(resolution_); }
  [[nodiscard]] std::size_t bytes() const {
    return blocks_.bytes() + cells_.size() * sizeof(cells_[0]);
  }

 private:
  using Block = std::array<Cell, VoxelBlocks::kVoxels>;

  /// For a centre at `p` from a patch's mean surface point, in edges of a voxel.
  static Cell cell_at(const SurfacePatch& patch, const Eigen::Vector3f& p, float reach);
  [[nodiscard]] Eigen::Vector3f to_lattice(const Eigen::Vector3f& p_map) const {
    return per_m_ * p_map - blocks_.origin();
  }
  /// In edges of a voxel.
  [[nodiscard]] float distance(const Place& place) const {
    constexpr float kUnit = 1.0F / 127.0F;
    const Cell& cell = *place.cell;
    const float rise = (place.within.x() - 0.5F) * static_cast<float>(cell.x) +
                       (place.within.y() - 0.5F) * static_cast<float>(cell.y) +
                       (place.within.z() - 0.5F) * static_cast<float>(cell.z);
    return std::abs(unit_ * static_cast<float>(cell.distance) + kUnit * rise);
  }

  float resolution_;  ///< [m]
  float per_m_;       ///< [voxels/m]
  float reach_;       ///< [voxels]
  float unit_;        ///< [voxels] Of a stored distance.
  float steps_;       ///< [1/voxel] Of a table.
  VoxelBlocks blocks_;
  std::vector<Block> cells_;
};

}  // namespace castaway::localization
