/// Distances to the surfaces of a 3-D map, stored near them only: what rays need.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "localization/volume/voxel_blocks.hpp"

namespace castaway::localization {

/// Truncated distances from the centres of voxels to the nearest surface points.
class VoxelDistances {
 public:
  /// `max_distance` [m]: larger distances read as this. @throws std::invalid_argument for an
  /// invalid map or distance, or a map with too many blocks.
  VoxelDistances(const VoxelMap& map, double max_distance);

  /// Distance from the centre of the voxel that a point is in. [m]
  [[nodiscard]] float at_point(const Eigen::Vector3f& p_map) const;
  /// Distance from the centre of a voxel, rounded to 1/255 of `max_distance`. [m]
  [[nodiscard]] float at_centre(const Eigen::Vector3i& voxel) const;

  [[nodiscard]] double resolution() const { return resolution_; }
  /// `is_rough` of the map.
  [[nodiscard]] bool rough() const { return rough_; }
  [[nodiscard]] std::size_t bytes() const {
    return blocks_.bytes() + distances_.size() * sizeof(Block);
  }

 private:
  using Block = std::array<std::uint8_t, VoxelBlocks::kVoxels>;

  double resolution_;
  bool rough_;
  float scale_ = 0.0F;  ///< [m] Of a unit.
  VoxelBlocks blocks_;
  std::vector<Block> distances_;
};

/// @throws std::invalid_argument unless distances reach 1 to 16 voxels.
void validate_reach(const VoxelMap& map, double max_distance);

}  // namespace castaway::localization
