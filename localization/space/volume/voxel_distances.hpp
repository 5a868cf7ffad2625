/// Distances to the surfaces of a 3-D map, stored near them only: what rays need.
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "localization/space/volume/voxel_blocks.hpp"

namespace castaway::localization {

/// Truncated distances from the centres of voxels to the nearest surface points.
class VoxelDistances {
 public:
  /// `max_distance` [m]: larger distances read as this. @throws std::invalid_argument for an
  /// invalid map or distance, or a map with too many blocks.
  VoxelDistances(const VoxelMap& map, double max_distance);

  /// Distance from the centre of the voxel that a point is in. [m]
  [[nodiscard]] float at_point(const Eigen::Vector3f& p_map) const {
    const Eigen::Vector3f p_lattice = p_map / static_cast<float>(resolution_) - blocks_.origin();
    return scale_ * static_cast<float>(distances_[blocks_.find(p_lattice).index]);
  }
  /// The same for four points, to the bit.
  [[nodiscard]] FourFloats at_points(FourFloats x, FourFloats y, FourFloats z) const {
    const auto edge = static_cast<float>(resolution_);
    const Eigen::Vector3f& first = blocks_.origin();
    const FourPlaces places =
        blocks_.find(x / edge - first.x(), y / edge - first.y(), z / edge - first.z());
    FourInts units;
    for (int k = 0; k < 4; ++k) {
      units[k] = distances_[blocks_.index(places.block[k], places.voxel[k])];
    }
    return scale_ * to_floats(units);
  }
  /// Distance from the centre of a voxel, rounded to 1/255 of `max_distance`. [m]
  [[nodiscard]] float at_centre(const Eigen::Vector3i& voxel) const;

  [[nodiscard]] double resolution() const { return resolution_; }
  /// `is_rough` of the map.
  [[nodiscard]] bool rough() const { return rough_; }
  [[nodiscard]] std::size_t bytes() const { return blocks_.bytes() + distances_.size(); }

 private:
  double resolution_;
  bool rough_;
  float scale_ = 0.0F;  ///< [m] Of a unit.
  VoxelBlocks blocks_;
  std::vector<std::uint8_t> distances_;  ///< By block and voxel; a block more, which is far.
};

/// @throws std::invalid_argument unless distances reach 1 to 16 voxels.
void validate_reach(const VoxelMap& map, double max_distance);

}  // namespace castaway::localization
