/// Distances of points from the surfaces of a 3-D map: point to plane.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <vector>

#include <Eigen/Geometry>

#include "localization/geometry/four_floats.hpp"
#include "localization/space/volume/surface_patches.hpp"
#include "localization/space/volume/voxel_blocks.hpp"

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
  /// Values of a function at 256 distances from 0 to the largest.
  using Table = std::array<float, 256>;

  /// `max_distance` [m]: larger distances read as this. @throws std::invalid_argument for an
  /// invalid map or distance, or a map with too many blocks.
  SurfaceField(const VoxelMap& map, double max_distance);

  /// Distance from a point to the nearest surface. [m]
  [[nodiscard]] float at(const Eigen::Vector3f& p_map) const {
    const PlaceOfPoint place = blocks_.find(to_lattice(p_map));
    const Cell& cell = cells_[place.index];
    const auto d = distance(Sample<float>{
        static_cast<float>(cell.distance),
        {static_cast<float>(cell.x), static_cast<float>(cell.y), static_cast<float>(cell.z)},
        {place.within.x(), place.within.y(), place.within.z()}});
    return resolution_ * std::min(d, reach_);
  }
  /// The same for four points, to the bit.
  [[nodiscard]] FourFloats at(FourFloats x, FourFloats y, FourFloats z) const {
    return resolution_ * up_to_reach(distance(sample(find_in_map(x, y, z))));
  }
  /// Distances of four points from the nearest surface, and how fast they grow along four
  /// directions.
  struct FourRates {
    FourFloats distance;  ///< [m]
    FourFloats rate;      ///< [m/m] For unit vectors; 0 far from all surfaces.
  };
  [[nodiscard]] FourRates rates(const FourPoints& p_map, const FourPoints& direction) const {
    const Sample<FourFloats> at = sample(find_in_map(p_map.x, p_map.y, p_map.z));
    const FourFloats d = signed_distance(at);
    const FourFloats rise =
        kUnit * (at.rise[0] * direction.x + at.rise[1] * direction.y + at.rise[2] * direction.z);
    return {resolution_ * up_to_reach(d < 0.0F ? -d : d), d < 0.0F ? -rise : rise};
  }
  /// Distance from the centre of the voxel that a point is in. [m]
  [[nodiscard]] float at_point(const Eigen::Vector3f& p_map) const {
    const Cell& cell = cells_[blocks_.find(to_lattice(p_map)).index];
    return resolution_ * unit_ * static_cast<float>(cell.distance);
  }
  /// The same for four points, to the bit.
  [[nodiscard]] FourFloats at_points(FourFloats x, FourFloats y, FourFloats z) const {
    const FourPoints p = to_lattice(x, y, z);
    const FourPlaces places = blocks_.find(p.x, p.y, p.z);
    FourFloats units;
    for (int k = 0; k < 4; ++k) {
      const Cell& cell = cells_[blocks_.index(places.block[k], places.voxel[k])];
      units[k] = static_cast<float>(cell.distance);
    }
    return resolution_ * unit_ * units;
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
  /// Four points as they are looked up: first their cells, then the values there.
  struct FourCells {
    FourFloats x, y, z;  ///< `PlaceOfPoint::within`
    std::array<const Cell*, 4> cells;
  };
  /// Coordinates are in the lattice. The cells are fetched into the cache, but not read.
  [[nodiscard]] FourCells find(FourFloats x, FourFloats y, FourFloats z) const {
    const FourPlaces places = blocks_.find(x, y, z);
    FourCells found{places.x, places.y, places.z, {}};
    for (int k = 0; k < 4; ++k) {
      const Cell* cell = &cells_[blocks_.index(places.block[k], places.voxel[k])];
      __builtin_prefetch(cell);
      found.cells[static_cast<std::size_t>(k)] = cell;
    }
    return found;
  }
  /// Places in a table for the points' distances from the nearest surface.
  [[nodiscard]] FourInts table_places(const FourCells& found) const {
    const FourFloats d = distance(sample(found));
    const FourFloats place = steps_ * d + 0.5F;
    const FourFloats last = FourFloats{} + 255.0F;
    return truncate(place < last ? place : last);
  }

  [[nodiscard]] double resolution() const { return static_cast<double>(resolution_); }
  [[nodiscard]] std::size_t bytes() const { return blocks_.bytes() + cells_.size() * sizeof(Cell); }

 private:
  /// A cell, and a point in it. `Number`: float or FourFloats.
  template <typename Number>
  struct Sample {
    Number distance;
    std::array<Number, 3> rise;
    std::array<Number, 3> within;
  };

  /// For a centre at `p` from a patch's mean surface point, in edges of a voxel.
  static Cell cell_at(const SurfacePatch& patch, const Eigen::Vector3f& p, float reach);
  [[nodiscard]] Eigen::Vector3f to_lattice(const Eigen::Vector3f& p_map) const {
    return per_m_ * p_map - blocks_.origin();
  }
  [[nodiscard]] FourPoints to_lattice(FourFloats x, FourFloats y, FourFloats z) const {
    const Eigen::Vector3f& first = blocks_.origin();
    return {per_m_ * x - first.x(), per_m_ * y - first.y(), per_m_ * z - first.z()};
  }
  static constexpr float kUnit = 1.0F / 127.0F;

  /// In edges of a voxel; negative behind the plane of the surface.
  template <typename Number>
  [[nodiscard]] Number signed_distance(const Sample<Number>& at) const {
    const Number rise = (at.within[0] - 0.5F) * at.rise[0] + (at.within[1] - 0.5F) * at.rise[1] +
                        (at.within[2] - 0.5F) * at.rise[2];
    return unit_ * at.distance + kUnit * rise;
  }
  template <typename Number>
  [[nodiscard]] Number distance(const Sample<Number>& at) const {
    const Number d = signed_distance(at);
    return d < 0.0F ? -d : d;
  }
  [[nodiscard]] FourFloats up_to_reach(FourFloats distance) const {
    const FourFloats most = FourFloats{} + reach_;
    return distance < most ? distance : most;
  }
  [[nodiscard]] FourCells find_in_map(FourFloats x, FourFloats y, FourFloats z) const {
    const FourPoints p = to_lattice(x, y, z);
    return find(p.x, p.y, p.z);
  }
  [[nodiscard]] static Sample<FourFloats> sample(const FourCells& found) {
    const FourInts cells = load_cells(found.cells);
    return {to_floats((cells << 24) >> 24),
            {to_floats((cells << 16) >> 24), to_floats((cells << 8) >> 24), to_floats(cells >> 24)},
            {found.x, found.y, found.z}};
  }
  /// Each cell as one number: the distance in the lowest byte, z in the highest.
  [[nodiscard]] static FourInts load_cells(const std::array<const Cell*, 4>& cells) {
    static_assert(std::endian::native == std::endian::little);
    std::array<std::int32_t, 4> bytes{};
    for (std::size_t k = 0; k < 4; ++k) std::memcpy(&bytes[k], cells[k], sizeof(Cell));
    return FourInts{bytes[0], bytes[1], bytes[2], bytes[3]};
  }

  float resolution_;  ///< [m]
  float per_m_;       ///< [voxels/m]
  float reach_;       ///< [voxels]
  float unit_;        ///< [voxels] Of a stored distance.
  float steps_;       ///< [1/voxel] Of a table.
  VoxelBlocks blocks_;
  std::vector<Cell> cells_;  ///< By block and voxel; a block more, which is far from all surfaces.
};

}  // namespace castaway::localization
