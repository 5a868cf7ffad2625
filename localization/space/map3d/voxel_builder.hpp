/// Makes a 3-D map of surface points.
#pragma once

#include "localization/space/map3d/voxel_map.hpp"

namespace castaway::localization {

/// Takes points in any order and in any number; memory grows with the voxels that they occupy.
class VoxelBuilder {
 public:
  /// @throws std::invalid_argument for an invalid resolution [m].
  explicit VoxelBuilder(double resolution);

  /// Adds a point of a surface, in map. [m] `faces_up`: it may be ground; true where surfaces have
  /// no known sides. @throws std::invalid_argument if it is not finite or farther from the origin
  /// than voxels are numbered.
  void add(const Eigen::Vector3d& p_map, bool faces_up = true);
  /// The map of all points so far. The builder is empty afterwards.
  VoxelMap build();

 private:
  /// Sum of the points in a voxel, from its lower corner, in edges.
  struct Sum {
    VoxelKey key = 0;
    Eigen::Vector3f points = Eigen::Vector3f::Zero();
    float count = 0.0F;
    bool faces_up = false;
  };
  void compact();

  double resolution_;
  double limit_;           ///< [m] Largest component.
  std::vector<Sum> sums_;  ///< Ascending up to `compacted_`, then as they came.
  std::size_t compacted_ = 0;
};

}  // namespace castaway::localization
