/// Occupied voxels of a 3-D map, stored sparsely: memory grows with the surfaces, not with space.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace castaway::localization {

/// A voxel's index in one number, ordered by z, then y, then x. Each component takes 21 bits.
using VoxelKey = std::uint64_t;

/// Largest component of a voxel's index, of either sign.
inline constexpr int kMaxVoxelIndex = (1 << 20) - 1;

VoxelKey voxel_key(const Eigen::Vector3i& index);
Eigen::Vector3i voxel_index(VoxelKey key);

/// Voxel (i, j, k) covers `[index * resolution, (index + 1) * resolution)` of map. Each holds the
/// mean of the surface in it, so that distances are not rounded to voxels.
struct VoxelMap {
  double resolution = 0.1;     ///< [m] Edge of a voxel.
  std::vector<VoxelKey> keys;  ///< Of the occupied voxels, ascending.
  /// Of the mean surface point from the voxel's lower corner, in 1/256 of its edge; as many as
  /// keys.
  std::vector<std::array<std::uint8_t, 3>> offsets;
  /// 1: a surface in it may face up; 0: none does. As many as keys.
  std::vector<std::uint8_t> faces_up;

  [[nodiscard]] std::size_t size() const { return keys.size(); }
  /// Memory that the voxels take.
  [[nodiscard]] std::size_t bytes() const {
    return keys.capacity() * sizeof(keys[0]) + offsets.capacity() * sizeof(offsets[0]) +
           faces_up.capacity() * sizeof(faces_up[0]);
  }
  [[nodiscard]] bool contains(const Eigen::Vector3i& index) const {
    return find(index).has_value();
  }
  /// Position of a voxel in `keys`; nothing if it is not occupied.
  [[nodiscard]] std::optional<std::size_t> find(const Eigen::Vector3i& index) const;
  /// Mean surface point of the i-th voxel in map. [m]
  [[nodiscard]] Eigen::Vector3d point(std::size_t i) const;
};

/// @throws std::invalid_argument if keys are not ascending or as many as offsets, or for a voxel
/// smaller than 1 mm or larger than 100 m.
void validate(const VoxelMap& map);

/// True if the surface points are in the same place of all voxels: the map's source states none, as
/// an OctoMap does, and its surfaces are as rough as its voxels.
bool is_rough(const VoxelMap& map);

/// The voxel of a point. Requires a point within `kMaxVoxelIndex`.
Eigen::Vector3i voxel_of(const Eigen::Vector3d& p_map, double resolution);

}  // namespace castaway::localization
