#include "localization/space/map3d/voxel_map.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace castaway::localization {
namespace {

constexpr unsigned kBits = 21;
constexpr VoxelKey kMask = (VoxelKey{1} << kBits) - 1;
constexpr int kBias = 1 << 20;

VoxelKey biased(int component) { return static_cast<VoxelKey>(component + kBias); }

int component(VoxelKey key, unsigned axis) {
  return static_cast<int>((key >> (kBits * axis)) & kMask) - kBias;
}

}  // namespace

VoxelKey voxel_key(const Eigen::Vector3i& index) {
  return (biased(index.z()) << (2 * kBits)) | (biased(index.y()) << kBits) | biased(index.x());
}

Eigen::Vector3i voxel_index(VoxelKey key) {
  return {component(key, 0), component(key, 1), component(key, 2)};
}

std::optional<std::size_t> VoxelMap::find(const Eigen::Vector3i& index) const {
  const VoxelKey key = voxel_key(index);
  const auto at = std::lower_bound(keys.begin(), keys.end(), key);
  if (at == keys.end() || *at != key) return std::nullopt;
  return static_cast<std::size_t>(at - keys.begin());
}

Eigen::Vector3d VoxelMap::point(std::size_t i) const {
  const auto& [x, y, z] = offsets[i];
  const Eigen::Vector3d within = (Eigen::Vector3d(x, y, z).array() + 0.5) / 256.0;
  return (voxel_index(keys[i]).cast<double>() + within) * resolution;
}

void validate(const VoxelMap& map) {
  if (!(map.resolution >= 0.001 && map.resolution <= 100.0)) {
    throw std::invalid_argument("a 3-D map's voxels must have edges of 1 mm to 100 m");
  }
  if (map.keys.size() != map.offsets.size() || map.keys.size() != map.faces_up.size()) {
    throw std::invalid_argument("a 3-D map must have a surface point for each voxel");
  }
  if (std::ranges::adjacent_find(map.keys, std::greater_equal<>()) != map.keys.end()) {
    throw std::invalid_argument("a 3-D map's voxels must be in ascending order, each once");
  }
}

bool is_rough(const VoxelMap& map) {
  return std::ranges::all_of(map.offsets,
                             [&](const auto& offset) { return offset == map.offsets.front(); });
}

Eigen::Vector3i voxel_of(const Eigen::Vector3d& p_map, double resolution) {
  return (p_map / resolution).array().floor().matrix().cast<int>();
}

}  // namespace castaway::localization
