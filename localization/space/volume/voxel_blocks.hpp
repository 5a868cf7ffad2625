/// Space around the surfaces of a 3-D map, in blocks of voxels: what is far from all surfaces takes
/// no memory.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "localization/geometry/four_floats.hpp"
#include "localization/space/map3d/voxel_map.hpp"

namespace castaway::localization {

/// A voxel by its block's number and its place in that block: x varies fastest, then y.
struct VoxelPlace {
  std::uint32_t block = 0;
  std::uint32_t voxel = 0;
};

/// The voxel of a point: its place among the voxels of all blocks, and where in it the point is.
struct PlaceOfPoint {
  std::size_t index = 0;   ///< `VoxelBlocks::kVoxels` times the block's number, plus the voxel.
  Eigen::Vector3f within;  ///< From the voxel's lower corner, in its edges.
};

/// Four points, before their blocks are read.
struct FourPlaces {
  FourInts block;      ///< Place of the block in the table.
  FourInts voxel;      ///< Place in the block.
  FourFloats x, y, z;  ///< `PlaceOfPoint::within`
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
    const Eigen::Vector3i v = local.cast<int>();
    const std::int32_t block = table_[static_cast<std::size_t>(table_place(v.x(), v.y(), v.z()))];
    if (block < 0) return std::nullopt;
    return VoxelPlace{static_cast<std::uint32_t>(block),
                      static_cast<std::uint32_t>(place_in_block(v.x(), v.y(), v.z()))};
  }
  /// The place of a point of the lattice. Far from surfaces, and for NaN, its block is one more
  /// than there are: `size()`.
  [[nodiscard]] PlaceOfPoint find(const Eigen::Vector3f& p_lattice) const {
    const Eigen::Vector3f p(clamp(p_lattice.x(), most_.x()), clamp(p_lattice.y(), most_.y()),
                            clamp(p_lattice.z(), most_.z()));
    const Eigen::Vector3i voxel = p.cast<int>();
    return {index(table_place(voxel.x(), voxel.y(), voxel.z()),
                  place_in_block(voxel.x(), voxel.y(), voxel.z())),
            p - voxel.cast<float>()};
  }
  /// The same in two steps for four points, to the bit: the second is `index`.
  [[nodiscard]] FourPlaces find(FourFloats px, FourFloats py, FourFloats pz) const {
    const FourFloats x = clamp(px, most_.x());
    const FourFloats y = clamp(py, most_.y());
    const FourFloats z = clamp(pz, most_.z());
    const FourInts column = truncate(x);
    const FourInts row = truncate(y);
    const FourInts layer = truncate(z);
    return {table_place(column, row, layer), place_in_block(column, row, layer),
            x - to_floats(column), y - to_floats(row), z - to_floats(layer)};
  }
  /// `PlaceOfPoint::index` of a block of the table and a voxel in it.
  [[nodiscard]] std::size_t index(int block, int voxel) const {
    // -1 becomes large.
    const auto number = static_cast<unsigned>(table_[static_cast<std::size_t>(block)]);
    return std::min(number, static_cast<unsigned>(count_)) * kVoxels +
           static_cast<std::size_t>(voxel);
  }
  /// Where the frame lattice begins: at the corner of the first block, in edges of a voxel.
  [[nodiscard]] const Eigen::Vector3f& origin() const { return origin_; }
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
  /// `Number`: int or FourInts; a voxel of the extent, counted from the first one.
  template <typename Number>
  [[nodiscard]] Number table_place(Number x, Number y, Number z) const {
    const auto columns = static_cast<int>(size_.x());
    const auto rows = static_cast<int>(size_.y());
    return ((z >> 2) * rows + (y >> 2)) * columns + (x >> 2);
  }
  template <typename Number>
  [[nodiscard]] static Number place_in_block(Number x, Number y, Number z) {
    return ((z & 3) << 4) | ((y & 3) << 2) | (x & 3);
  }
  void mark(const VoxelMap& map, int reach);

  Eigen::Vector3i first_ = Eigen::Vector3i::Zero();   ///< Voxel at the corner of the first block.
  Eigen::Vector3f origin_ = Eigen::Vector3f::Zero();  ///< `first_`
  Eigen::Matrix<unsigned, 3, 1> size_{1, 1, 1};       ///< [blocks]
  Eigen::Matrix<unsigned, 3, 1> extent_{kEdge, kEdge, kEdge};       ///< [voxels]
  Eigen::Vector3f most_ = Eigen::Vector3f::Constant(kEdge - 0.5F);  ///< In the last voxel.
  std::vector<std::int32_t> table_{-1};  ///< Number of each block; -1: none.
  std::int32_t count_ = 0;
};

}  // namespace castaway::localization
