/// Distances to the surfaces of a 3-D map, stored near them only.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "localization/map3d/voxel_map.hpp"

namespace castaway::localization {

/// Truncated distances at the centres of voxels, in blocks of 8 x 8 x 8 bytes. Blocks without a
/// surface within `max_distance` are not stored.
class VoxelDistances {
 public:
  /// `max_distance` [m]: larger distances read as this. @throws std::invalid_argument for an
  /// invalid map or distance, or a map whose blocks would be too many to be numbered.
  VoxelDistances(const VoxelMap& map, double max_distance);

  /// Distance from a point to the nearest surface, interpolated between voxel centres. [m]
  /// Distances have no sign: nearer to a surface than half a voxel, it may read up to half a voxel.
  [[nodiscard]] float at(const Eigen::Vector3f& p_map) const { return interpolate(p_map, steps_); }
  /// Distance from the centre of the voxel that a point is in. [m]
  [[nodiscard]] float at_point(const Eigen::Vector3f& p_map) const;
  /// Interpolates a function of distance, tabulated at the 256 distances that are stored
  /// (`tabulate`).
  [[nodiscard]] float interpolate(const Eigen::Vector3f& p_map,
                                  const std::array<float, 256>& values) const;
  /// Values of `f(distance [m])` for `interpolate`.
  template <typename Function>
  [[nodiscard]] std::array<float, 256> tabulate(const Function& f) const {
    std::array<float, 256> values{};
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] = static_cast<float>(f(static_cast<double>(scale_) * static_cast<double>(i)));
    }
    return values;
  }
  /// Distance from the centre of a voxel, rounded to 1/255 of `max_distance`. [m]
  [[nodiscard]] float at_centre(const Eigen::Vector3i& voxel) const {
    return scale_ * static_cast<float>(byte_at(voxel));
  }

  [[nodiscard]] double resolution() const { return resolution_; }
  [[nodiscard]] double max_distance() const { return max_distance_; }
  [[nodiscard]] std::size_t bytes() const {
    return blocks_.size() * sizeof(Block) + table_.size() * sizeof(table_[0]);
  }

 private:
  static constexpr int kEdge = 8;  // [voxels]
  using Block = std::array<std::uint8_t, kEdge * kEdge * kEdge>;

  /// Surface points by the block that they are in.
  struct BlockPoints {
    std::vector<std::uint32_t> first;  ///< Of each block; one more at the end.
    std::vector<Eigen::Vector3f> points;

    [[nodiscard]] std::span<const Eigen::Vector3f> of(std::size_t block) const {
      return std::span(points).subspan(first[block], first[block + 1] - first[block]);
    }
  };

  void lay_out(const VoxelMap& map, int reach);
  void spread(const VoxelMap& map);
  [[nodiscard]] BlockPoints sort_by_block(const VoxelMap& map) const;
  template <typename Function>
  void for_each_around(const Eigen::Vector3i& block, int around, const Function& f) const;
  void fill(const Eigen::Vector3i& block, const BlockPoints& points);
  [[nodiscard]] std::size_t table_index(const Eigen::Vector3i& block) const;
  [[nodiscard]] const Block* block_around(const Eigen::Vector3i& local) const;
  [[nodiscard]] std::uint8_t byte_at(const Eigen::Vector3i& voxel) const;
  [[nodiscard]] std::array<std::uint8_t, 8> corners_at(const Eigen::Vector3i& voxel) const;

  double resolution_;
  double max_distance_;
  std::array<float, 256> steps_{};                   ///< [m] The distances that are stored.
  float scale_ = 0.0F;                               ///< [m] Of a unit.
  Eigen::Vector3i first_ = Eigen::Vector3i::Zero();  ///< Voxel at the corner of the first block.
  Eigen::Vector3i size_ = Eigen::Vector3i::Zero();   ///< [blocks]
  std::vector<std::int32_t> table_;                  ///< Index into `blocks_`; -1: none.
  std::vector<Block> blocks_;
};

}  // namespace castaway::localization
