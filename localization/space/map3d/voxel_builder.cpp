#include "localization/space/map3d/voxel_builder.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace castaway::localization {
namespace {

constexpr std::size_t kPending = std::size_t{1} << 20U;  // Points before voxels are summed up.

std::uint8_t to_offset(float mean) {
  return static_cast<std::uint8_t>(std::clamp(std::floor(256.0F * mean), 0.0F, 255.0F));
}

}  // namespace

VoxelBuilder::VoxelBuilder(double resolution)
    : resolution_(resolution), limit_(resolution * kMaxVoxelIndex) {
  validate(VoxelMap{resolution, {}, {}, {}});
}

void VoxelBuilder::add(const Eigen::Vector3d& p_map, bool faces_up) {
  if (!(p_map.cwiseAbs().maxCoeff() < limit_)) {
    throw std::invalid_argument("a surface point is not finite, or too far from the origin");
  }
  const Eigen::Vector3i index = voxel_of(p_map, resolution_);
  const Eigen::Vector3d within = p_map / resolution_ - index.cast<double>();
  const VoxelKey key = voxel_key(index);
  if (sums_.size() > compacted_ && sums_.back().key == key) {  // Surfaces come piece by piece.
    sums_.back().points += within.cast<float>();
    sums_.back().count += 1.0F;
    sums_.back().faces_up |= faces_up;
    return;
  }
  sums_.push_back({key, within.cast<float>(), 1.0F, faces_up});
  if (sums_.size() - compacted_ >= std::max(kPending, compacted_)) compact();
}

/// Sorts, and joins the sums of each voxel.
void VoxelBuilder::compact() {
  const auto as_they_came = sums_.begin() + static_cast<std::ptrdiff_t>(compacted_);
  std::ranges::stable_sort(as_they_came, sums_.end(), {}, &Sum::key);
  std::ranges::inplace_merge(sums_, as_they_came, {}, &Sum::key);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < sums_.size(); ++i) {
    if (kept > 0 && sums_[kept - 1].key == sums_[i].key) {
      sums_[kept - 1].points += sums_[i].points;
      sums_[kept - 1].count += sums_[i].count;
      sums_[kept - 1].faces_up |= sums_[i].faces_up;
    } else {
      sums_[kept++] = sums_[i];
    }
  }
  sums_.resize(kept);
  compacted_ = kept;
}

VoxelMap VoxelBuilder::build() {
  compact();
  VoxelMap map;
  map.resolution = resolution_;
  map.keys.reserve(sums_.size());
  map.offsets.reserve(sums_.size());
  map.faces_up.reserve(sums_.size());
  for (const Sum& sum : sums_) {
    const Eigen::Vector3f mean = sum.points / sum.count;
    map.keys.push_back(sum.key);
    map.offsets.push_back({to_offset(mean.x()), to_offset(mean.y()), to_offset(mean.z())});
    map.faces_up.push_back(sum.faces_up ? 1 : 0);
  }
  sums_.clear();
  compacted_ = 0;
  return map;
}

}  // namespace castaway::localization
