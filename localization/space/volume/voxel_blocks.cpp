#include "localization/space/volume/voxel_blocks.hpp"

#include <algorithm>
#include <stdexcept>

namespace castaway::localization {
namespace {

constexpr std::int64_t kMostBlocks = std::int64_t{1} << 28U;  // Of the table, stored or not.

}  // namespace

VoxelBlocks::VoxelBlocks(const VoxelMap& map, int reach) {
  if (map.size() == 0) return;
  const int margin = reach + 2;  // Beyond the reach; points at -0.5 are rounded to 0.
  Eigen::Vector3i low = voxel_index(map.keys.front());
  Eigen::Vector3i high = low;
  for (const VoxelKey key : map.keys) {
    low = low.cwiseMin(voxel_index(key));
    high = high.cwiseMax(voxel_index(key));
  }
  first_ = low.array() - margin;
  origin_ = first_.cast<float>();
  const Eigen::Vector3i extent = (high - first_).array() + margin;
  size_ = (extent / kEdge + Eigen::Vector3i::Ones()).cast<unsigned>();
  extent_ = unsigned{kEdge} * size_;
  most_ = extent_.cast<float>().array() - 0.5F;
  const std::int64_t blocks = size_.cast<std::int64_t>().prod();
  if (blocks > kMostBlocks) {
    throw std::invalid_argument("a 3-D map is too large for its resolution: use larger voxels");
  }
  table_.assign(static_cast<std::size_t>(blocks), -1);
  mark(map, reach);
  for (std::int32_t& block : table_) {
    if (block == 0) block = count_++;
  }
}

void VoxelBlocks::mark(const VoxelMap& map, int reach) {
  for (const VoxelKey key : map.keys) {
    const Eigen::Vector3i voxel = voxel_index(key) - first_;
    const Eigen::Vector3i from = (voxel.array() - reach) / kEdge;
    const Eigen::Vector3i to = (voxel.array() + reach) / kEdge;
    for (int z = from.z(); z <= to.z(); ++z) {
      for (int y = from.y(); y <= to.y(); ++y) {
        for (int x = from.x(); x <= to.x(); ++x) table_[table_index({x, y, z})] = 0;
      }
    }
  }
}

}  // namespace castaway::localization
