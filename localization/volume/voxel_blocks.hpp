/// Space around the surfaces of a 3-D map, in blocks of voxels: what is far from all surfaces takes
/// no memory.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "localization/map3d/voxel_map.hpp"

namespace castaway::localization {

/// A voxel by its block's number and its place in that block: x varies fastest, then y.
struct VoxelPlace {
  std::uint32_t block = 0;
  std::uint32_t voxel = 0;
};

/// The voxel of a point.
struct PlaceOfPoint {
  VoxelPlace voxel;
  Eigen::Vector3f within;  ///< From the voxel's lower corner, in its edges.
};

/// The blocks of 4 x 4 x 4 voxels near surfaces, numbered. Frame lattice: map, moved to the corner
/// of the first block, in edges of a voxel. The outermost voxels are far from all surfaces.
class VoxelBlocks {
 public:
  static constexpr int kEdge = 4;  ///< [voxels]
  static constexpr std::size_t kVoxels = std::size_t{kEdge} * kEdge * kEdge;

  VoxelBlocks() = default;
  /// Blocks that reach within `reach` voxels of a surface along each axis.
  /// @throws std::invalid_argument if they would be too many to be numbered.
  VoxelBlocks(const VoxelMap& map, int reach);

  /// Number of blocks.
  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(count_); }
  /// The place of a voxel; nothing far from surfaces.
  [[nodiscard]] std::optional<VoxelPlace> find(const Eigen::Vector3i& voxel) const {
    // Voxels before the first one become large.
    const Eigen::Matrix<unsigned, 3, 1> local = (voxel - first_).cast<unsigned>();
    if (local.x() >= extent_.x() || local.y() >= extent_.y() || local.z() >= extent_.z()) {
      return std::nullopt;
    }
    return find_local(local.x(), local.y(), local.z());
  }
  /// The voxel of a point of the lattice, and where in it the point is; nothing far from surfaces,
  /// and for NaN.
  [[nodiscard]] std::optional<PlaceOfPoint> find(const Eigen::Vector3f& p_lattice) const {
    const Eigen::Vector3i voxel = p_lattice.cast<int>();
    const auto x = static_cast<unsigned>(voxel.x());  // Large if it is below 0, or NaN.
    const auto y = static_cast<unsigned>(voxel.y());
    const auto z = static_cast<unsigned>(voxel.z());
    if (x >= extent_.x() || y >= extent_.y() || z >= extent_.z()) return std::nullopt;
    const auto place = find_local(x, y, z);
    if (!place) return std::nullopt;
    return PlaceOfPoint{*place, p_lattice - voxel.cast<float>()};
  }
  /// Where the frame lattice begins: at the corner of the first block, in edges of a voxel.
  [[nodiscard]] Eigen::Vector3f origin() const { return first_.cast<float>(); }
  [[nodiscard]] std::size_t bytes() const { return table_.size() * sizeof(table_[0]); }

  /// Calls `f(index, number)` with each block's index along the axes and its number.
  template <typename Function>
  void for_each(const Function& f) const {
    for_each_within(Eigen::Vector3i::Zero(), size_.cast<int>() - Eigen::Vector3i::Ones(), f);
  }
  /// The same for the blocks at most `around` from one.
  template <typename Function>
  void for_each_around(const Eigen::Vector3i& block, int around, const Function& f) const {
    for_each_within((block.array() - around).max(0),
                    (block.array() + around).min(size_.cast<int>().array() - 1), f);
  }
  /// The voxel at the corner of a block.
  [[nodiscard]] Eigen::Vector3i corner(const Eigen::Vector3i& block) const {
    return first_ + kEdge * block;
  }

 private:
  template <typename Function>
  void for_each_within(const Eigen::Vector3i& low, const Eigen::Vector3i& high,
                       const Function& f) const {
    for (int z = low.z(); z <= high.z(); ++z) {
      for (int y = low.y(); y <= high.y(); ++y) {
        for (int x = low.x(); x <= high.x(); ++x) {
          const Eigen::Vector3i index(x, y, z);
          const std::int32_t number = table_[table_index(index)];
          if (number >= 0) f(index, static_cast<std::uint32_t>(number));
        }
      }
    }
  }
  [[nodiscard]] std::size_t table_index(const Eigen::Vector3i& block) const {
    const Eigen::Matrix<std::size_t, 3, 1> b = block.cast<std::size_t>();
    return (b.z() * size_.y() + b.y()) * size_.x() + b.x();
  }
  /// For a voxel of the extent, counted from the first one.
  [[nodiscard]] std::optional<VoxelPlace> find_local(unsigned x, unsigned y, unsigned z) const {
    constexpr unsigned kBlock = kEdge;
    const std::size_t at =
        (std::size_t{z / kBlock} * size_.y() + y / kBlock) * size_.x() + x / kBlock;
    const std::int32_t block = table_[at];
    if (block < 0) return std::nullopt;
    return VoxelPlace{static_cast<std::uint32_t>(block),
                      ((z & 3U) << 4U) | ((y & 3U) << 2U) | (x & 3U)};
  }
  void mark(const VoxelMap& map, int reach);

  Eigen::Vector3i first_ = Eigen::Vector3i::Zero();  ///< Voxel at the corner of the first block.
  Eigen::Matrix<unsigned, 3, 1> size_ = Eigen::Matrix<unsigned, 3, 1>::Zero();    ///< [blocks]
  Eigen::Matrix<unsigned, 3, 1> extent_ = Eigen::Matrix<unsigned, 3, 1>::Zero();  ///< [voxels]
  std::vector<std::int32_t> table_;  ///< Number of each block; -1: none.
  std::int32_t count_ = 0;
};

}  // namespace castaway::localization
