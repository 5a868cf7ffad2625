/// A map as a normal distributions transform: surface points in large cells, each cell one normal
/// distribution or a few.
///
/// P. Biber, W. Strasser, "The Normal Distributions Transform: A New Approach to Laser Scan
/// Matching", IROS 2003. Differences: points in a cell that are not on one plane, such as both
/// faces of a wall, are split into several distributions; and a distribution is wider along its
/// surface than its points are, because surfaces do not end with their cells.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "localization/map/occupancy_grid.hpp"
#include "localization/space/map3d/voxel_map.hpp"
#include "localization/space/ndt/fit_distributions.hpp"

namespace castaway::localization {

/// Settings of the cells.
struct NdtConfig {
  double cell = 0.5;   ///< [m] Edge of a cell.
  double along = 4.0;  ///< Factor of the standard deviations along a surface.
};

/// @throws std::invalid_argument if a value is out of range.
void validate(const NdtConfig& config);

/// Built once, then only read.
class NdtMap {
 public:
  /// Of a planar map: the centres of its occupied cells, as walls without end in z.
  /// @throws std::invalid_argument for invalid settings, or a map too large for its cells.
  NdtMap(const OccupancyGrid& grid, const NdtConfig& config);
  /// Of the mean surface points of a 3-D map.
  NdtMap(const VoxelMap& voxels, const NdtConfig& config);

  /// True: points are in the plane of a planar map, with z = 0.
  [[nodiscard]] bool is_planar() const { return planar_; }
  [[nodiscard]] const std::vector<NormalDistribution>& distributions() const {
    return distributions_;
  }
  /// Calls `take` with all distributions of the cells nearest to a point: eight in space, four in
  /// the plane. At least those within half an edge of it are among them.
  template <typename Take>
  void for_each_near(const Eigen::Vector3f& p_map, const Take& take) const {
    const Eigen::Vector3i corner = corner_of(p_map);
    for (int k = 0; k < (planar_ ? 4 : 8); ++k) {
      for (const NormalDistribution& d : at(corner + Eigen::Vector3i(k & 1, k >> 1 & 1, k >> 2))) {
        take(d);
      }
    }
  }

 private:
  /// Cubes in space.
  struct Lattice {
    float per_m = 1.0F;                                ///< [cells/m]
    Eigen::Vector3f origin = Eigen::Vector3f::Zero();  ///< [m] In map.
    Eigen::Vector3i size = Eigen::Vector3i::Zero();    ///< [cells]

    [[nodiscard]] std::size_t index(const Eigen::Vector3i& cell) const;
  };

  NdtMap(std::vector<Eigen::Vector3f> points, double spacing, const NdtConfig& config, bool planar);

  static Lattice lattice_around(const std::vector<Eigen::Vector3f>& points, double cell);
  /// Appends the distributions of points that are sorted by their cells.
  void fit(std::vector<Eigen::Vector3f>& points, const std::vector<std::size_t>& cells,
           const FitConfig& config);
  /// The lowest of the cells nearest to a point.
  [[nodiscard]] Eigen::Vector3i corner_of(const Eigen::Vector3f& p_map) const {
    const Eigen::Array3f at = lattice_.per_m * (p_map - lattice_.origin).array() - 0.5F;
    Eigen::Vector3i corner = at.floor().cwiseMax(-2.0F).cwiseMin(kFar).cast<int>();
    if (planar_) corner.z() = 0;
    return corner;
  }
  [[nodiscard]] std::span<const NormalDistribution> at(const Eigen::Vector3i& cell) const;

  static constexpr float kFar = 1e6F;

  bool planar_;
  Lattice lattice_;
  std::vector<std::uint32_t> first_;  ///< Of each cell's distributions; one more at the end.
  std::vector<NormalDistribution> distributions_;
};

}  // namespace castaway::localization
