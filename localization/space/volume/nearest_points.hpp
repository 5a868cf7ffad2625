/// The nearest surface point of each voxel near the surfaces of a 3-D map.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "localization/space/volume/voxel_blocks.hpp"

namespace castaway::localization {

/// A voxel's lower corner from that of its block, in edges of a voxel, by its place in the block.
Eigen::Vector3f corner_in_block(std::uint32_t voxel);

/// Mean surface point of a map's i-th voxel from the voxel's lower corner, in its edges.
Eigen::Vector3f point_in_voxel(const VoxelMap& map, std::size_t i);

/// Nearest points of the voxels of a block, by their place.
struct NearestPoints {
  /// Squared distances from the voxels' centres, in edges of a voxel.
  std::array<float, VoxelBlocks::kVoxels> squares;
  /// Position of the surface point in the map; valid where the square is below that of the radius.
  std::array<std::uint32_t, VoxelBlocks::kVoxels> points;
};

/// Surface points sorted by blocks.
class SurfacePoints {
 public:
  /// Farther points than `radius`, in edges of a voxel, are left out. `blocks` must outlive it, and
  /// have a block for each voxel of `map`.
  SurfacePoints(const VoxelMap& map, const VoxelBlocks& blocks, float radius);

  /// Nearest points of the voxels of a block (index along the axes). Of points that are equally
  /// near, those of the block itself come first, then those of blocks in their order.
  [[nodiscard]] NearestPoints nearest(const Eigen::Vector3i& block) const;

 private:
  struct Point {
    Eigen::Vector3f p;        ///< In edges of a voxel, from the corner of its block.
    std::uint32_t index = 0;  ///< In the map.
  };
  /// A block near another one.
  struct Neighbour {
    Eigen::Vector3i offset;  ///< [blocks]
    float square;            ///< Least, from the voxels' centres to its points.
  };
  static std::vector<Neighbour> neighbours_within(float radius);

  const VoxelBlocks& blocks_;
  float radius_;
  std::vector<Neighbour> neighbours_;  ///< The nearest first, beginning with the block itself.
  std::vector<std::uint32_t> first_;   ///< Of each block; one more at the end.
  std::vector<Point> points_;
};

}  // namespace castaway::localization
